"""Matches a regular expression in time linear in the text: all paths through the expression are followed in parallel.

Python's `re` backtracks, so `(a+)+$` takes twice as long for each further character, and it blocks the whole process meanwhile.
Here a set of states moves along the text (Thompson 1968), each with the positions of its groups (Pike). States are kept in the
order in which `re` would try them, and a loop that consumed no character ends where `re` ends it (_sre: MAX_UNTIL, `last_ptr`),
so the result is the same. Single characters are compared by `re` itself.
"""

from __future__ import annotations

import re
import sys
from collections.abc import Generator
from typing import Any

if sys.version_info >= (3, 11):
    from re import _compiler, _parser  # type: ignore[attr-defined]
else:
    import sre_compile as _compiler
    import sre_parse as _parser

MOST_STATES = 4000
"""An expression with more states, like `(a{1,99}){1,99}`, is refused."""

LETTERS_PER_TURN = 200
"""Characters of the text after which `find` yields."""

Spans = tuple[int, ...]
"""Start and end of each group, the whole match first; -1 for a group that did not participate."""

_LETTER, _WIDTHLESS, _SPLIT, _SAVE, _ENTER, _ROUND, _LEAVE, _JUMP, _MATCH = range(9)
_REPEATS = (_parser.MAX_REPEAT, _parser.MIN_REPEAT)
_LETTERS = (_parser.LITERAL, _parser.NOT_LITERAL, _parser.ANY, _parser.IN)
_ASSERTIONS = (_parser.AT, _parser.ASSERT, _parser.ASSERT_NOT)


class NotRegular(Exception):
    """The expression has a backreference or is too large: it cannot be matched here."""


def parsed(pattern: str, flags: int) -> Any:
    """Return `re`'s parse tree of an expression. Raises re.error."""
    return _parser.parse(pattern, flags)


class LinearMatcher:
    """One compiled expression. Raises NotRegular."""

    def __init__(self, tree: Any, flags: int) -> None:
        self._state = tree.state
        self._flags = flags | tree.state.flags
        self._steps: list[tuple[Any, ...]] = []
        self._loops = 0
        self._tests: dict[int, dict[str, bool]] = {}
        self.groups: int = tree.state.groups
        self._emit_all(tree, self._flags)
        self._emit(_MATCH)

    def find(
        self, text: str, start: int, *, whole: bool = False, anchored: bool = False, advance: bool = False
    ) -> Generator[None, None, Spans | None]:
        """Search from `start` on; returns the spans of the first match. Yields regularly, so that other programs can run.

        `whole`: match up to the end of the text; `anchored`: only at `start`; `advance`: no empty match at `start`.
        """
        found: Spans | None = None
        states: list[tuple[int, Spans]] = []
        nothing = (-1,) * (2 * self.groups)
        for at in range(start, len(text) + 1):
            if (at - start) % LETTERS_PER_TURN == LETTERS_PER_TURN - 1:
                yield
            reached: list[tuple[int, Spans]] = []
            seen: set[tuple[int, int]] = set()
            letter = text[at : at + 1]
            ended = False
            for state, spans in states:
                if (match := self._close(state, spans, text, at, seen, reached, start, whole, advance)) is not None:
                    found, ended = match, True
                    break
            if not ended and found is None and (at == start or not anchored):
                match = self._close(0, (at, *nothing[1:]), text, at, seen, reached, start, whole, advance)
                found = match if match is not None else found
            states = [(state + 1, spans) for state, spans in reached if letter and self._fits(state, letter, text, at)]
            if not states and (found is not None or anchored):
                break
        return found

    def _close(
        self,
        first: int,
        spans: Spans,
        text: str,
        at: int,
        seen: set[tuple[int, int]],
        reached: list[tuple[int, Spans]],
        start: int,
        whole: bool,
        advance: bool,
    ) -> Spans | None:
        """Follow all steps that consume no character, in order; collect the possible next characters; return at a match."""
        stack = [(first, 0, spans)]
        while stack:
            state, rounds, spans = stack.pop()
            if (state, rounds) in seen:
                continue
            seen.add((state, rounds))
            kind, *rest = self._steps[state]
            if kind == _LETTER:
                reached.append((state, spans))
            elif kind == _JUMP:
                stack.append((rest[0], rounds, spans))
            elif kind == _SPLIT:
                stack.extend((each, rounds, spans) for each in reversed(rest[0]))
            elif kind == _SAVE:
                slot = rest[0]
                stack.append((state + 1, rounds, (*spans[:slot], at, *spans[slot + 1 :])))
            elif kind in (_ENTER, _LEAVE):
                stack.append((state + 1, rounds & ~rest[0], spans))
            elif kind == _ROUND:
                bit, body, after, lazy = rest
                branches = [(after, rounds & ~bit, spans)]
                if not rounds & bit:  # the last iteration consumed a character, or there was none
                    branches.insert(1 if lazy else 0, (body, rounds | bit, spans))
                stack.extend(reversed(branches))
            elif kind == _WIDTHLESS:
                if rest[0].match(text, at) is not None:
                    stack.append((state + 1, rounds, spans))
            elif not ((whole and at != len(text)) or (advance and at == start)):
                return (spans[0], at, *spans[2:])
        return None

    def _fits(self, state: int, letter: str, text: str, at: int) -> bool:
        known = self._tests.setdefault(state, {})
        if letter not in known:
            known[letter] = self._steps[state][1].match(text, at) is not None
        return known[letter]

    # -- compiling -----------------------------------------------------------------------------------------------------

    def _emit(self, *step: Any) -> int:
        if len(self._steps) >= MOST_STATES:
            raise NotRegular
        self._steps.append(step)
        return len(self._steps) - 1

    def _emit_all(self, items: Any, flags: int) -> None:
        for item in items:
            self._emit_item(item, flags)

    def _emit_item(self, item: tuple[Any, Any], flags: int) -> None:
        kind, value = item
        if kind in _LETTERS:
            self._emit(_LETTER, self._test(item, flags))
        elif kind in _ASSERTIONS:
            self._emit(_WIDTHLESS, self._test(item, flags))
        elif kind is _parser.SUBPATTERN:
            group, more, less, inner = value
            if group:
                self._emit(_SAVE, 2 * group)
            self._emit_all(inner, _changed(flags, more, less))
            if group:
                self._emit(_SAVE, 2 * group + 1)
        elif kind is _parser.BRANCH:
            self._emit_branches(value[1], flags)
        elif kind in _REPEATS:
            self._emit_repeat(*value, lazy=kind is _parser.MIN_REPEAT, flags=flags)
        elif kind is _parser.FAILURE:
            self._emit(_SPLIT, ())
        else:
            raise NotRegular

    def _emit_branches(self, branches: Any, flags: int) -> None:
        split = self._emit(_SPLIT, ())
        starts, jumps = [], []
        for branch in branches:
            starts.append(len(self._steps))
            self._emit_all(branch, flags)
            jumps.append(self._emit(_JUMP, 0))
        self._steps[split] = (_SPLIT, tuple(starts))
        for jump in jumps:
            self._steps[jump] = (_JUMP, len(self._steps))

    def _emit_repeat(self, least: int, most: Any, body: Any, *, lazy: bool, flags: int) -> None:
        endless = most is _parser.MAXREPEAT
        bit = 1 << self._loops
        self._loops += 1
        self._emit(_ENTER, bit)
        for _ in range(least):
            self._emit_all(body, flags)
        rounds = []
        for _ in range(1 if endless else most - least):
            rounds.append(self._emit(_ROUND))
            self._emit_all(body, flags)
            if endless:
                self._emit(_JUMP, rounds[-1])
        after = self._emit(_LEAVE, bit)
        for state in rounds:
            self._steps[state] = (_ROUND, bit, state + 1, after, lazy)

    def _test(self, item: tuple[Any, Any], flags: int) -> Any:
        """Return `re`'s own pattern for one character or one assertion."""
        if item[0] in (_parser.ASSERT, _parser.ASSERT_NOT) and not _is_simple(item[1][1]):
            raise NotRegular
        inner = _parser.SubPattern(self._state, [item])
        here = (None, flags & (_LOCAL | _parser.TYPE_FLAGS), _LOCAL & ~flags, inner)
        return _compiler.compile(_parser.SubPattern(self._state, [(_parser.SUBPATTERN, here)]), self._flags)


_LOCAL = int(re.IGNORECASE | re.MULTILINE | re.DOTALL)
"""Flags that a part of an expression can remove: `(?-i:a)`."""


def _changed(flags: int, more: int, less: int) -> int:
    """Return the flags inside `(?i-s:…)`, combined as in sre_compile."""
    if more & _parser.TYPE_FLAGS:
        flags &= ~_parser.TYPE_FLAGS
    return (flags | more) & ~less


def _is_simple(tree: Any) -> bool:
    """Return whether a lookahead or lookbehind has neither groups nor loops."""
    return all(kind in _LETTERS or kind is _parser.AT for kind, _ in tree)
