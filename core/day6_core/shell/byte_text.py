"""Text of the shell that can represent any bytes: what is not UTF-8 is encoded as in Python's file names (surrogateescape).

So a byte of a file, a pipe or a name comes out as it came in; a terminal shows a replacement character.
"""

from __future__ import annotations

from day6_core.session.harmless import KEEP_BYTES


def of_byte(value: int) -> str:
    """Return the text for one byte."""
    return chr(value) if value < 0x80 else chr(0xDC00 + value)


def of_code(code: int) -> str:
    """Return the text for the UTF-8 of a code point, even one that isn't a character, as bash's `\\u` does."""
    return chr(min(code, 0x10FFFF)).encode("utf-8", "surrogatepass").decode("utf-8", "surrogateescape")


def joined(text: str) -> str:
    """Return `text` with every run of bytes that is a character in UTF-8 as that character, and `?` for what is neither."""
    return text if text.isascii() else text.encode("utf-8", KEEP_BYTES).decode("utf-8", "surrogateescape")
