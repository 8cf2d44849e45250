"""Textual's text area for code: keys and pastes are offered to a subclass first, and no character of the text is changed.

What a key costs doesn't grow with the text: Textual colours all of it again, and counts its lines for each that it draws.
"""

from __future__ import annotations

from typing import TYPE_CHECKING

from textual import events
from textual._tree_sitter import get_language
from textual.document._document_navigator import DocumentNavigator
from textual.document._wrapped_document import WrappedDocument
from textual.widgets import TextArea

from day6_tui.textual_private.document import document_of

if TYPE_CHECKING:
    from textual.document._syntax_aware_document import SyntaxAwareDocument
    from tree_sitter import Query

BLOCK = 64
"""Lines whose colours are asked of the syntax tree together, when one of them is drawn."""


class Highlights(dict[int, list[tuple[int, int | None, str]]]):
    """What is coloured in each line, in bytes from its start: those of a block of lines, once one of them is looked at."""

    def __init__(self, document: SyntaxAwareDocument, query: Query) -> None:
        self._document, self._query = document, query

    def __bool__(self) -> bool:
        return True  # Textual asks nothing of a mapping that seems empty

    def __missing__(self, line: int) -> list[tuple[int, int | None, str]]:
        first = line - line % BLOCK
        end = first + BLOCK
        self.update((each, []) for each in range(first, end))
        for name, nodes in self._document.query_syntax_tree(self._query, (first, 0), (end, 0)).items():
            for node in nodes:
                (top, left), (bottom, right) = node.start_point, node.end_point
                for each in range(max(top, first), min(bottom + 1, end)):
                    self[each].append((left if each == top else 0, right if each == bottom else None, name))
        return self[line]


class _Wrapped(WrappedDocument):
    @property
    def height(self) -> int:
        """The number of rows, which Textual counts each time."""
        return len(self._offset_to_line_info)


class CodeArea(TextArea):
    """Base of a text area that decides itself what keys mean."""

    async def take_key(self, event: events.Key) -> bool:
        """Handle a key; False for one that Textual goes on with."""
        raise NotImplementedError

    def take_paste(self, event: events.Paste) -> None:
        """See, and change, what is about to be inserted."""

    async def type_key(self, event: events.Key) -> bool:
        """Do what a key does in any text area; return whether it was bound to something.

        At once: Textual looks for bindings later, when the next key may have been handled.
        """
        if bound := self._bindings.key_to_bindings.get(event.key):
            await self.run_action(bound[0].action)
            return True
        await super()._on_key(event)
        return False

    def forget_lines(self) -> None:
        """Draw all lines anew."""
        self._line_cache.clear()
        self.refresh()

    def _build_highlight_map(self) -> None:
        self._line_cache.clear()
        self._highlights.clear()
        if self._highlight_query:
            self._highlights = Highlights(self.document, self._highlight_query)  # type: ignore[arg-type]

    async def _on_key(self, event: events.Key) -> None:
        if await self.take_key(event):
            event.stop()
            event.prevent_default()

    async def _on_paste(self, event: events.Paste) -> None:
        event.stop()  # the text area, which gets the event next, inserts it; nothing else may
        self.take_paste(event)

    def _set_document(self, text: str, language: str | None) -> None:
        """Like TextArea's, with documents that change no character."""
        document = document_of(text, get_language(language) if language else None)
        self._highlight_query = None
        if language:
            self._highlight_query = document.prepare_query(self._get_builtin_highlight_query(language))
        self.document = document
        self.wrapped_document = _Wrapped(document, tab_width=self.indent_width)
        self.navigator = DocumentNavigator(self.wrapped_document)
        self._build_highlight_map()
        self.move_cursor((0, 0))
        self._rewrap_and_refresh_virtual_size()
