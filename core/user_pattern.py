"""Searches with a regular expression that a user wrote: what it finds is what `re` finds, and no expression stops the program.

`re` tries one way after the other and lets nobody else go on meanwhile. An expression by which it may go astray on a text of
this length is matched by `core.linear_match` instead; one that cannot be (it refers back to a group) is refused.
"""

from __future__ import annotations

import functools
import math
import re
from collections.abc import Callable, Generator, Iterator
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any, TypeVar

if TYPE_CHECKING:
    from day6_tui.core.linear_match import LinearMatcher

LONGEST_SEARCH = 4 * 10**8
"""Steps that `re` may take at most, well below a second."""

_Result = TypeVar("_Result")
_REPEATS = ("MAX_REPEAT", "MIN_REPEAT", "POSSESSIVE_REPEAT")


class TooComplex(re.error):
    """An expression that nobody can match in a bearable time."""

    def __init__(self) -> None:
        super().__init__("regular expression would take too long")


@dataclass(frozen=True)
class Found:
    """What a search found, as `re.Match`."""

    text: str
    spans: tuple[int, ...]

    def __getitem__(self, group: int) -> str | None:
        start, end = self.span(group)
        return self.text[start:end] if start >= 0 else None

    @property
    def whole(self) -> str:
        return self.text[self.spans[0] : self.spans[1]]

    def span(self, group: int = 0) -> tuple[int, int]:
        return self.spans[2 * group], self.spans[2 * group + 1]


class UserPattern:
    """A compiled expression. Raises re.error, also for one that is too deep or too large; so do the searches (TooComplex)."""

    def __init__(self, pattern: str, flags: int = 0) -> None:
        from day6_tui.core.linear_match import parsed

        try:
            self._tree = parsed(pattern, flags)
            self._compiled = re.compile(pattern, flags)
        except (RecursionError, OverflowError, MemoryError):
            raise re.error("regular expression too big") from None
        self._flags = flags
        self._quick: dict[int, bool] = {}
        """By the number of binary digits of a text's length: whether `re` may search it."""
        self.groups = self._compiled.groups

    def search(self, text: str) -> Found | None:
        """The first match anywhere."""
        return _at_once(self.searching(text))

    def match(self, text: str) -> Found | None:
        """The match at the beginning."""
        return _at_once(self.searching(text, anchored=True))

    def fullmatch(self, text: str) -> Found | None:
        """The match that is the whole text."""
        return _at_once(self.searching(text, anchored=True, whole=True))

    def finditer(self, text: str) -> Iterator[Found]:
        """Each match, in order."""
        return iter(_at_once(self.finding(text)))

    def finding(self, text: str, count: int = 0) -> Generator[None, None, list[Found]]:
        """All matches, or the first `count`; yields now and then (see `core.session.task.in_turns`)."""
        found: list[Found] = []
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

    def replacing(self, text: str, by: Callable[[Found], str], count: int = 0) -> Generator[None, None, str]:
        """The text with each match, or the first `count`, replaced by what `by` says; yields as `finding`."""
        pieces, done = [], 0
        for match in (yield from self.finding(text, count)):
            pieces += [text[done : match.spans[0]], by(match)]
            done = match.spans[1]
        return "".join([*pieces, text[done:]])

    def searching(
        self, text: str, start: int = 0, *, anchored: bool = False, whole: bool = False, advance: bool = False
    ) -> Generator[None, None, Found | None]:
        """The first match from `start` on; `advance`: not the empty text there. Yields now and then, as `finding`."""
        if not advance and self._is_quick(text):
            search = self._compiled.fullmatch if whole else self._compiled.match if anchored else self._compiled.search
            match = search(text, start)
            return None if match is None else _as_found(match)
        spans = yield from self._linear.find(text, start, anchored=anchored, whole=whole, advance=advance)
        return None if spans is None else Found(text, spans)

    def _is_quick(self, text: str) -> bool:
        """Whether `re` cannot take longer than it may."""
        digits = len(text).bit_length()
        if digits not in self._quick:
            length = 2.0 ** max(digits, 1)  # a search begins at any letter: once more
            self._quick[digits] = math.log(length) + _effort(self._tree, length) <= math.log(LONGEST_SEARCH)
        return self._quick[digits]

    @functools.cached_property
    def _linear(self) -> LinearMatcher:
        from day6_tui.core.linear_match import LinearMatcher, NotRegular

        try:
            return LinearMatcher(self._tree, self._flags)
        except (NotRegular, RecursionError):
            raise TooComplex from None


@functools.lru_cache(maxsize=64)
def user_pattern(pattern: str, flags: int = 0) -> UserPattern:
    """The compiled expression, kept for the next time. Raises re.error."""
    return UserPattern(pattern, flags)


def _as_found(match: re.Match[str]) -> Found:
    return Found(match.string, tuple(place for span in match.regs for place in span))


def _at_once(work: Generator[None, None, _Result]) -> _Result:
    while True:
        try:
            next(work)
        except StopIteration as end:
            result: _Result = end.value
            return result


def _effort(tree: Any, length: float) -> float:
    """The logarithm of how many ways `re` may go through a part on a text of this length; infinite where loops are nested.

    A loop may end after any letter, each alternative is one way more, and what follows is tried after each of them. A loop
    around a part that matches in several ways has as many with every letter.
    """
    return sum(_effort_of(str(kind), value, length) for kind, value in tree)


def _effort_of(kind: str, value: Any, length: float) -> float:
    if kind in _REPEATS:
        least, most, body = value
        if most == 1:
            return math.log(2) + _effort(body, length)
        if _effort(body, length) > 0:
            return math.inf
        return math.log(min(max(int(most) - least, 1), length))
    if kind == "SUBPATTERN":
        return _effort(value[3], length)
    if kind == "BRANCH":
        ways = 1 if _differ_at_once(value[1]) else len(value[1])
        return math.log(ways) + max(_effort(branch, length) for branch in value[1])
    if kind in ("ASSERT", "ASSERT_NOT"):
        return _effort(value[1], length)
    if kind == "ATOMIC_GROUP":
        return _effort(value, length)
    if kind == "GROUPREF_EXISTS":
        return max(_effort(branch, length) for branch in value[1:] if branch is not None)
    return math.log(length) if kind == "GROUPREF" else 0


def _differ_at_once(branches: Any) -> bool:
    """Whether the first letter tells which of the alternatives it is."""
    letters = {chr(branch[0][1]).lower() for branch in branches if len(branch) and str(branch[0][0]) == "LITERAL"}
    return len(letters) == len(branches)
