"""iTerm2's inline images: every piece is a small PNG.

https://iterm2.com/documentation-images.html
"""

from __future__ import annotations

from base64 import standard_b64encode
from io import BytesIO

from PIL import Image

from day6_tui.pixels.bands import Array
from day6_tui.pixels.inline import Inline


class ITerm(Inline):
    """Writes pieces as files."""

    def encoded(self, pixels: Array, columns: int, rows: int) -> str:
        return encoded(pixels, columns, rows)


def encoded(pixels: Array, columns: int, rows: int) -> str:
    """A picture that fills so many cells."""
    file = BytesIO()
    Image.fromarray(pixels).save(file, "PNG", compress_level=1)
    data = file.getvalue()
    size = f"size={len(data)};width={columns};height={rows};preserveAspectRatio=0;doNotMoveCursor=1"
    return f"\x1b]1337;File=inline=1;{size}:{standard_b64encode(data).decode()}\x07"
