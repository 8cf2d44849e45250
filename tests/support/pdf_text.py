"""What a PDF says: its texts read back by another library than the one that wrote them."""

from __future__ import annotations

from pathlib import Path

from pypdf import PdfReader


def pdf_text(file: Path) -> str:
    """The text of a PDF of one page, without spaces and ends of lines, where they depend on the reader."""
    (page,) = PdfReader(file, strict=True).pages
    return "".join(page.extract_text().split())


def pdf_size(file: Path) -> tuple[float, float]:
    """Width and height of the first page in points."""
    box = PdfReader(file, strict=True).pages[0].mediabox
    return float(box.width), float(box.height)
