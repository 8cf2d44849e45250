"""What becomes of characters in the set 'ascii': drawings are ASCII, and letters too where the locale isn't UTF-8."""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from unicodedata import east_asian_width

from rich.cells import cell_len
from rich.segment import Segment
from textual.strip import Strip

from day6_tui.appearance.look import Look


def showable(strip: Strip, look: Look) -> Strip:
    """Replace what the glyphs of a look rule out."""
    return strip if look.glyphs.unicode else Strip(in_ascii(strip, letters=look.letters), strip.cell_length)


def in_ascii(segments: Iterable[Segment], *, letters: bool) -> Iterator[Segment]:
    """Replace drawings, and without `letters` those too: by a similar ASCII character, else by `?` (`??` for a wide one)."""
    for segment in segments:
        text = segment.text
        if not text.isascii():
            text = "".join(c if c.isascii() or (letters and _is_letter(c)) else _plain(c) for c in text)
            segment = Segment(text, segment.style, segment.control)
        yield segment


def _is_letter(char: str) -> bool:
    """Whether a character belongs to a text, as letters and the marks between Chinese ones do, and not to a drawing."""
    return char.isalpha() or east_asian_width(char) in "WF"


def _plain(char: str) -> str:
    return _LIKENESSES.get(char) or "?" * cell_len(char)


_LIKENESSES = dict(zip("↑↓←→…·×°–—“”‘’▸•−", "^v<>~.xo--\"\"''>*-", strict=True))
