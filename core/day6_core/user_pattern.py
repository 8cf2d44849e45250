"""Searches with a user's regular expression: the results are those of `re`, but no expression can block the program.

`re` backtracks and blocks the whole process meanwhile. An expression for which it might take too long on a text of this length
is matched by `core.linear_match` instead; one that cannot be (with a backreference) is refused.
"""

from __future__ import annotations

import functools
import math
import re
from collections.abc import Callable, Generator, Iterator
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any, TypeVar

if TYPE_CHECKING:
    from day6_core.linear_match import LinearMatcher

LONGEST_SEARCH = 4 * 10**8
"""The most steps `re` may take, well below a second."""

_Result = TypeVar("_Result")
_REPEATS = ("MAX_REPEAT", "MIN_REPEAT", "POSSESSIVE_REPEAT")


class TooComplex(re.error):
    """An expression that cannot be matched in a reasonable time."""

    def __init__(self) -> None:
        super().__init__("regular expression would take too long")


@dataclass(frozen=True)
class Match:
    """A match, with the interface of `re.Match`."""

    text: str
    spans: tuple[int, ...]

    def __getitem__(self, group: int) -> str | None:
        start, end = self.span(group)
        return self.text[start:end] if start >= 0 else None

    @property
    def whole(self) -> str:
        """The matched text."""
        return self.text[self.spans[0] : self.spans[1]]

    def span(self, group: int = 0) -> tuple[int, int]:
        """Return start and end of a group, (-1, -1) if it did not participate."""
        return self.spans[2 * group], self.spans[2 * group + 1]


class UserPattern:
    """A compiled expression.

    Raises:
        re.error: the expression is invalid, too deep or too large; TooComplex, a subclass, may also be raised by searches.
    """

    def __init__(self, pattern: str, flags: int = 0) -> None:
        from day6_core.linear_match import parsed

        try:
            self._tree = parsed(pattern, flags)
            self._compiled = re.compile(pattern, flags)
        except (RecursionError, OverflowError, MemoryError):
            raise re.error("regular expression too big") from None
        self._flags = flags
        self._quick: dict[int, bool] = {}
        """bit length of a text's length -> whether `re` may search it"""
        self.groups = self._compiled.groups

    def search(self, text: str) -> Match | None:
        """Return the first match anywhere, None if there is none."""
        return _run_to_end(self.searching(text))

    def match(self, text: str) -> Match | None:
        """Return the match at the beginning, None if there is none."""
        return _run_to_end(self.searching(text, anchored=True))

    def fullmatch(self, text: str) -> Match | None:
        """Return the match of the whole text, None if there is none."""
        return _run_to_end(self.searching(text, anchored=True, whole=True))

    def finditer(self, text: str) -> Iterator[Match]:
        """Yield all matches in order."""
        return iter(_run_to_end(self.finding(text)))

    def finding(self, text: str, count: int = 0) -> Generator[None, None, list[Match]]:
        """Return all matches, or the first `count`; yields regularly (see `day6_core.session.task.in_turns`)."""
        found: list[Match] = []
        if self._is_quick(text):
            for match in self._compiled.finditer(text):
                found.append(_as_found(match))
                if len(found) == count:
                    break
            return found
        start, advance = 0, False
        while start <= len(text):
            match_here = yield from self.searching(text, start, advance=advance)
            if match_here is None:
                break
            found.append(match_here)
            if len(found) == count:
                break
            start, advance = match_here.spans[1], match_here.spans[0] == match_here.spans[1]
            yield
        return found

    def replacing(self, text: str, by: Callable[[Match], str], count: int = 0) -> Generator[None, None, str]:
        """Return the text with each match, or the first `count`, replaced by `by(match)`; yields like `finding`."""
        pieces, done = [], 0
        for match in (yield from self.finding(text, count)):
            pieces += [text[done : match.spans[0]], by(match)]
            done = match.spans[1]
        return "".join([*pieces, text[done:]])

    def searching(
        self, text: str, start: int = 0, *, anchored: bool = False, whole: bool = False, advance: bool = False
    ) -> Generator[None, None, Match | None]:
        """Return the first match from `start` on; `advance`: no empty match there. Yields like `finding`."""
        if not advance and self._is_quick(text):
            search = self._compiled.fullmatch if whole else self._compiled.match if anchored else self._compiled.search
            match = search(text, start)
            return None if match is None else _as_found(match)
        spans = yield from self._linear.find(text, start, anchored=anchored, whole=whole, advance=advance)
        return None if spans is None else Match(text, spans)

    def _is_quick(self, text: str) -> bool:
        """Return whether `re` needs at most LONGEST_SEARCH steps."""
        digits = len(text).bit_length()
        if digits not in self._quick:
            length = 2.0 ** max(digits, 1)  # a search starts at every character, hence log(length) once more
            self._quick[digits] = math.log(length) + _path_count(self._tree, length) <= math.log(LONGEST_SEARCH)
        return self._quick[digits]

    @functools.cached_property
    def _linear(self) -> LinearMatcher:
        from day6_core.linear_match import LinearMatcher, NotRegular

        try:
            return LinearMatcher(self._tree, self._flags)
        except (NotRegular, RecursionError):
            raise TooComplex from None


@functools.lru_cache(maxsize=64)
def user_pattern(pattern: str, flags: int = 0) -> UserPattern:
    """Return the compiled expression, cached. Raises re.error."""
    return UserPattern(pattern, flags)


def _as_found(match: re.Match[str]) -> Match:
    return Match(match.string, tuple(place for span in match.regs for place in span))


def _run_to_end(work: Generator[None, None, _Result]) -> _Result:
    while True:
        try:
            next(work)
        except StopIteration as end:
            result: _Result = end.value
            return result


def _path_count(tree: Any, length: float) -> float:
    """Return the logarithm of the number of paths `re` may take through a part on a text of this length; inf for nested loops.

    A loop may end after any character, each alternative adds a path, and the rest is tried after each of them. A loop around a
    part with several paths multiplies them with every character.
    """
    return sum(_path_count_of(str(kind), value, length) for kind, value in tree)


def _path_count_of(kind: str, value: Any, length: float) -> float:
    if kind in _REPEATS:
        least, most, body = value
        if most == 1:
            return math.log(2) + _path_count(body, length)
        if _path_count(body, length) > 0:
            return math.inf
        return math.log(min(max(int(most) - least, 1), length))
    if kind == "SUBPATTERN":
        return _path_count(value[3], length)
    if kind == "BRANCH":
        ways = 1 if _differ_at_once(value[1]) else len(value[1])
        return math.log(ways) + max(_path_count(branch, length) for branch in value[1])
    if kind in ("ASSERT", "ASSERT_NOT"):
        return _path_count(value[1], length)
    if kind == "ATOMIC_GROUP":
        return _path_count(value, length)
    if kind == "GROUPREF_EXISTS":
        return max(_path_count(branch, length) for branch in value[1:] if branch is not None)
    return math.log(length) if kind == "GROUPREF" else 0


def _differ_at_once(branches: Any) -> bool:
    """Return whether the first character decides between the alternatives."""
    letters = {chr(branch[0][1]).lower() for branch in branches if len(branch) and str(branch[0][0]) == "LITERAL"}
    return len(letters) == len(branches)
