"""Breaks text into lines of terminal cells: between words, and anywhere between Chinese characters."""

from __future__ import annotations

from bisect import bisect_right
from collections.abc import Callable

from day6_core.width import text_width


def wrap(text: str, width: int, measure: Callable[[str], int] = text_width) -> list[str]:
    """Break `text`, without control characters but newlines, into lines of at most `width` cells, which `measure` counts."""
    width = max(2, width)
    lines: list[str] = []
    for paragraph in text.split("\n"):
        if measure(paragraph) <= width:
            lines.append(paragraph.rstrip())
            continue
        line, used = "", 0
        for word in _words(paragraph, measure):
            size = measure(word)
            if used + size > width and line:
                lines.append(line.rstrip())
                line, used = "", 0
                word = word.lstrip()
                size = measure(word)
            while size > width:
                head = _head(_fitting(word, width, measure))
                lines.append(head)
                word = word[len(head) :]
                size = measure(word)
            line += word
            used += size
        lines.append(line.rstrip())
    return lines


_GOES_ON = ("/", "_-.:=,")
"""Signs at the end of a line that say that a path or name goes on below, without a blank: the best first."""


def _fitting(word: str, width: int, measure: Callable[[str], int]) -> str:
    """The longest beginning that fits."""
    count = bisect_right(range(len(word) + 1), width, key=lambda length: measure(word[:length])) - 1
    return word[:count].rstrip()


def _head(text: str) -> str:
    """What to show of a word before a break: up to a sign that shows the break to be none of the word's own."""
    for signs in _GOES_ON:
        if (end := max(text.rfind(sign) for sign in signs) + 1) > len(text) // 2:
            return text[:end]
    return text


_NO_LINE_START = set("，。、；：！？）》」』”’…")
_NO_LINE_END = set("（《「『“‘")


def _words(text: str, measure: Callable[[str], int]) -> list[str]:
    """Pieces that must not be broken: words with the space after them, single wide characters with closing marks."""
    pieces: list[str] = []
    word = ""
    for char in text:
        if char in _NO_LINE_START and (word or pieces):
            if word:
                word += char
            else:
                pieces[-1] += char
        elif char in _NO_LINE_END:
            if word:
                pieces.append(word)
            word = char
        elif measure(char) == 2:
            if word and word[-1] not in _NO_LINE_END:
                pieces.append(word)
                word = ""
            pieces.append(word + char)
            word = ""
        elif char == " ":
            pieces.append(word + " ")
            word = ""
        else:
            word += char
    if word:
        pieces.append(word)
    return pieces
