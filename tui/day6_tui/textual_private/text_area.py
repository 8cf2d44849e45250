"""Textual's text area for code: keys and pastes are offered to a subclass first, and no character of the text is changed."""

from __future__ import annotations

from textual import events
from textual._tree_sitter import get_language
from textual.document._document_navigator import DocumentNavigator
from textual.document._wrapped_document import WrappedDocument
from textual.widgets import TextArea

from day6_tui.textual_private.document import document_of


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
        self.wrapped_document = WrappedDocument(document, tab_width=self.indent_width)
        self.navigator = DocumentNavigator(self.wrapped_document)
        self._build_highlight_map()
        self.move_cursor((0, 0))
        self._rewrap_and_refresh_virtual_size()
