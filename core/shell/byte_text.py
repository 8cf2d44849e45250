"""Text of the shell that may stand for any bytes: what is not UTF-8 is in it as in Python's file names (surrogateescape).

So a byte of a file, a pipe or a name comes out again as it came in; a terminal shows a stand-in for it.
"""

from __future__ import annotations


def of_byte(value: int) -> str:
    """Return what stands for one byte."""
    return chr(value) if value < 0x80 else chr(0xDC00 + value)


def of_code(code: int) -> str:
    """Return what stands for the UTF-8 of a code point; also one that is no character, as bash's `\\u` does."""
    return chr(min(code, 0x10FFFF)).encode("utf-8", "surrogatepass").decode("utf-8", "surrogateescape")


def joined(text: str) -> str:
    """Return `text` with every run of bytes that is a character in UTF-8 as that character."""
    return text if text.isascii() else text.encode("utf-8", "surrogateescape").decode("utf-8", "surrogateescape")
