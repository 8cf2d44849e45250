"""The lines of an editor's text: Textual's documents, but only a newline ends a line.

Textual uses `str.splitlines`, for which form feeds, U+2028 and nine more end a line too, and then writes all of them as
newlines. Here every other character belongs to a line, so that the text stays as it was.
"""

from __future__ import annotations

from typing import TYPE_CHECKING

from textual.document._document import Document, EditResult, Location
from textual.document._syntax_aware_document import SyntaxAwareDocument

if TYPE_CHECKING:
    from tree_sitter import Language


class PlainDocument(Document):
    """A text without highlighting. `text` is exactly what it was made from."""

    def __init__(self, text: str) -> None:
        self._newline = "\n"
        self._lines = text.split("\n")

    def replace_range(self, start: Location, end: Location, text: str) -> EditResult:
        """Replace what lies between two places with `text`."""
        (top, left), (bottom, right) = sorted((start, end))
        replaced = self.get_text_range(start, end)
        before = self._lines[top][:left] if top < len(self._lines) else ""
        after = self._lines[bottom][right:] if bottom < len(self._lines) else ""
        new = text.split("\n")
        new[0] = before + new[0]
        place = (top + len(new) - 1, len(new[-1]))
        new[-1] += after
        self._lines[top : bottom + 1] = new
        return EditResult(place, replaced)


class ColouredLines(SyntaxAwareDocument, PlainDocument):
    """A text in a language; the order of its base classes makes `Lines` define the lines."""


def document_of(text: str, language: Language | None) -> PlainDocument:
    """Return the document of `text`, with a syntax tree where there is a language."""
    return PlainDocument(text) if language is None else ColouredLines(text, language)
