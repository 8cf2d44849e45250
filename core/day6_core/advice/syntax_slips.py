"""Slips that a line of Python shows itself, where Python says `invalid syntax`: habits of C, of shells, of Chinese keyboards."""

from __future__ import annotations

import keyword
import re
from dataclasses import replace
from pathlib import Path
from typing import NamedTuple

from day6_core.advice.fault import Fault
from day6_core.facts.folders import text_of
from day6_urdf.chinese import english

_VAGUE = re.compile(
    r"invalid syntax|expected ':'|unterminated|cannot assign to|invalid decimal literal|illegal target|EOL while"
)
"""Messages that leave open what is wrong."""

_TABLE: tuple[tuple[str, str], ...] = (
    # What a line without its texts has -> the key of the words about it; the first group is {found}.
    (r"\s*(else +if)\b", "syntax.elif"),
    (r"\s*for *\(.*;", "syntax.for"),
    (r".*(?<!&)(&&)(?!&)", "syntax.and"),
    (r".*(\|\|)", "syntax.or"),
    (r".*(?:^|[\s(])(!)\w", "syntax.not"),
    (r"\s*(?:if|while|elif)\b.*\b(then) *:?\s*$", "syntax.then"),
    (r"\s*(\w+)(?:\+\+|--);?\s*$", "syntax.plus"),
    (_BRACE := r"\s*(?:if|for|while|def|class|else|elif|try)\b.*(\{)\s*$", "syntax.brace"),
    (r"\s*(int|float|double|string|String|bool|var|let|const|auto|char) +\w+ *(?:=|$)", "syntax.type"),
    (r"\s*(void|function|func) +\w+ *\(", "syntax.def"),
)
_TEXT = re.compile(r"'[^']*'|\"[^\"]*\"|#.*")
_WORD = re.compile(r"\s*(\w+) *=(?!=)")
_CHINESE_WORD = re.compile(r"[\u4e00-\u9fff]+(?:[\s，。！？]+[\u4e00-\u9fff]+)*")


class Slip(NamedTuple):
    """The key of the words about it, what they fill in, and the line."""

    key: str
    found: str
    line: int


def slip_in_line(fault: Fault, cwd: Path) -> Slip | None:
    """Return what is wrong in the line of a syntax error, None if the line does not show it."""
    if not _VAGUE.search(fault.message):
        return None
    line = line_of(fault, cwd)
    before = line_of(replace(fault, line=fault.line - 1), cwd)
    if re.match(_BRACE, _TEXT.sub("", before)) is not None:  # Python only misses the brace's partner
        return Slip("syntax.brace", "{", fault.line - 1)
    plain = _TEXT.sub("''", line)
    if fault.message.startswith("unterminated"):
        quote = re.search(r"[‘’“”]", plain)
        return Slip("syntax.quote", quote[0], fault.line) if quote is not None else None
    for pattern, key in _TABLE:
        if (seen := re.match(pattern, plain)) is not None:
            return Slip(key, seen[1] if seen.lastindex else "", fault.line)
    word = _WORD.match(plain)
    if word is not None and keyword.iskeyword(word[1]):
        return Slip("syntax.keyword", word[1], fault.line)
    chinese = _CHINESE_WORD.search(plain)
    return Slip("syntax.text", english(chinese[0]), fault.line) if chinese is not None else None


def line_of(fault: Fault, cwd: Path) -> str:
    """Return the pupil's line that an exception names; '' if it is not there any more."""
    lines = text_of(cwd / fault.file).split("\n") if fault.file else []
    return lines[fault.line - 1] if 0 < fault.line <= len(lines) else ""
