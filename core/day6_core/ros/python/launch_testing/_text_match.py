"""Matchers of texts and of lines: a text, a compiled pattern, or a list of these that follow each other."""

from __future__ import annotations

import os
import re
from collections.abc import Callable, Iterable, Sequence
from typing import Any

Span = tuple[int, int]
TextMatch = Callable[..., "Span | None"]
"""`match(text, start=0)` returns where the expected text is, None if it isn't there."""
LineMatch = Callable[..., "Span | None"]
"""`match(lines, start=0)` returns the numbers of the first line and of the one after the last, None if they aren't there."""

_COLOURS = re.compile("\033\\[\\d{1,2}m")


def without_ansi_colours(text: str) -> str:
    """Return a text without the sequences that colour it, as osrf_pycommon's `remove_ansi_escape_sequences`."""
    return _COLOURS.sub("", text)


def normalize_lineseps(lines: str) -> str:
    """Return a text whose lines end with a newline alone."""
    return lines.replace(os.linesep, "\n").replace("\r\n", "\n")


def build_text_match(expected_text: Any, *, strict: bool = False) -> TextMatch:
    """Return a matcher of texts; with `strict` nothing may stand before, between and, for a plain text, after what is expected.

    Raises ValueError for what is no text, no pattern and no list.
    """
    if isinstance(expected_text, str):

        def match_text(actual: str, start: int = 0) -> Span | None:
            actual = normalize_lineseps(actual)
            if strict:
                return (start, start + len(expected_text)) if actual[start:] == expected_text else None
            found = actual.find(expected_text, start)
            return None if found < 0 else (found, found + len(expected_text))

        return match_text
    if hasattr(expected_text, "search") and hasattr(expected_text, "match"):

        def match_pattern(actual: str, start: int = 0) -> Span | None:
            look = expected_text.match if strict else expected_text.search
            found = look(normalize_lineseps(actual), start)
            return None if found is None else (found.start(), found.end())

        return match_pattern
    if isinstance(expected_text, Iterable):
        return _one_after_the_other([build_text_match(each) for each in expected_text], strict)
    raise ValueError("Unknown format for expected text")


def build_line_match(expected_lines: Any, *, strict: bool = False) -> LineMatch:
    """Return a matcher of lists of lines: with `strict` each of them must be as expected, otherwise one contains it.

    Raises ValueError as `build_text_match` does.
    """
    if isinstance(expected_lines, str):
        if strict:
            return _line_match(lambda line: bool(line == expected_lines), strict)
        return _line_match(lambda line: expected_lines in line, strict)
    if hasattr(expected_lines, "match"):
        return _line_match(lambda line: expected_lines.match(line) is not None, strict)
    if isinstance(expected_lines, Iterable):
        return _one_after_the_other([build_line_match(each) for each in expected_lines], strict)
    raise ValueError("Unknown format for expected lines")


def _line_match(fits: Callable[[str], bool], strict: bool) -> LineMatch:
    def match(actual: Sequence[str], start: int = 0) -> Span | None:
        if strict:
            return (start, max(start, len(actual))) if all(map(fits, actual[start:])) else None
        return next(((number, number + 1) for number in range(start, len(actual)) if fits(actual[number])), None)

    return match


def _one_after_the_other(matches: Sequence[Callable[..., Span | None]], strict: bool) -> Callable[..., Span | None]:
    def match(actual: Any, start: int = 0) -> Span | None:
        first, end = None, start
        for each in matches:
            found = each(actual, end)
            if found is None or (strict and found[0] != end):
                return None
            first = found[0] if first is None else first
            end = found[1]
        return None if first is None else (first, end)

    return match
