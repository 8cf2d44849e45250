"""How many terminal cells a text takes (Chinese characters two, combining marks none)."""

from __future__ import annotations

from functools import lru_cache
from unicodedata import category, east_asian_width


@lru_cache(maxsize=4096)
def char_width(char: str) -> int:
    """Cells of one character: 0, 1 or 2. Control characters count as 0."""
    if " " <= char <= "~":
        return 1
    if category(char) in ("Mn", "Me", "Cf", "Cc"):
        return 0
    return 2 if east_asian_width(char) in "WF" else 1


def is_mark(char: str) -> bool:
    """Whether a character belongs to the one before it: accents and Indic vowels, not what only chooses among glyphs."""
    if category(char) not in ("Mn", "Me"):
        return False
    return not ("\ufe00" <= char <= "\ufe0f" or "\U000e0100" <= char <= "\U000e01ef")


def text_width(text: str) -> int:
    """Cells of a text without control characters."""
    return len(text) if text.isascii() else sum(map(char_width, text))
