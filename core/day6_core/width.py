"""Widths of texts in terminal cells (Chinese characters take two, combining marks none)."""

from __future__ import annotations

from functools import lru_cache
from unicodedata import category, east_asian_width


@lru_cache(maxsize=4096)
def char_width(char: str) -> int:
    """Return the cells of one character: 0, 1 or 2. Control characters count as 0."""
    if " " <= char <= "~":
        return 1
    if category(char) in ("Mn", "Me", "Cf", "Cc"):
        return 0
    return 2 if east_asian_width(char) in "WF" else 1


def is_mark(char: str) -> bool:
    """Return whether a character combines with the one before it: accents and Indic vowels, but not variation selectors."""
    if category(char) not in ("Mn", "Me"):
        return False
    return not ("\ufe00" <= char <= "\ufe0f" or "\U000e0100" <= char <= "\U000e01ef")


class _Digits(dict[int, str]):
    """Code point -> its width as a digit, for `str.translate`; caches the common ones."""

    def __missing__(self, code: int) -> str:
        digit = str(char_width(chr(code)))
        if len(self) < MOST_REMEMBERED:
            self[code] = digit
        return digit


MOST_REMEMBERED = 20_000
_digits = _Digits()


def widths(text: str) -> str:
    """Return the width of every character of a text, as a string of the digits 0, 1 and 2."""
    return text.translate(_digits)


def fitting(digits: str, start: int, columns: int) -> int:
    """Return how many characters from `start` on fit into `columns` cells, by `widths(text)`, which must not contain 0."""
    count = min(columns, len(digits) - start)
    while (excess := count + digits.count("2", start, start + count) - columns) > 0:
        count -= (excess + 1) // 2
    return count


def text_width(text: str) -> int:
    """Return the cells of a text without control characters."""
    if text.isascii():
        return len(text)
    digits = widths(text)
    return len(text) + digits.count("2") - digits.count("0")
