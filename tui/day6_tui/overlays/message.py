"""Texts to read over the panes: an error, and the log of a program."""

from __future__ import annotations

from collections.abc import Sequence

from textual.app import ComposeResult
from textual.binding import Binding
from textual.widget import Widget

from day6_tui.appearance.look import Look
from day6_tui.overlays.modal import Modal, lines_of, plain
from day6_tui.panes.cells import wrap

FRAME = 3
"""Columns of a frame and a scroll bar."""


class ErrorModal(Modal):
    """Shows an error: in plain words, and in the catalogue's or the real tool's own."""

    BINDINGS = [Binding("enter,q,space", "close", show=False)]

    def __init__(self, look: Look, text: str) -> None:
        super().__init__(look, look.texts("error.title"), look.texts("error.continue"))
        self._text = text

    def inside(self) -> ComposeResult:
        from textual.containers import VerticalScroll
        from textual.content import Content
        from textual.widgets import Button, Static

        self._scroll = VerticalScroll(Static(Content("\n").join(lines_of(self._text)), classes="text"))
        self._scroll.can_focus = False
        yield self._scroll
        self._button = Button(self.look.texts("error.close"), compact=True)
        yield self._button

    @property
    def keyboard(self) -> Widget:
        return self._button

    def on_button_pressed(self) -> None:
        self.close()


class LogModal(Modal):
    """Lines to read and to copy: what a program has written, with the newest at the end, or the text of a message."""

    BINDINGS = [Binding("enter,q", "close", show=False), Binding("c", "copy_all", show=False)]

    def __init__(self, look: Look, title: str, lines: Sequence[str], *, from_top: bool = False) -> None:
        super().__init__(look, title, look.texts("log.keys"))
        self._lines = lines
        self._from_top = from_top

    def action_copy_all(self) -> None:
        """c: all of it goes to the clipboard of the terminal."""
        self.app.copy_to_clipboard("\n".join(self._lines))
        self.query_one("#frame").border_subtitle = plain(self.look.texts("log.copied"))

    def inside(self) -> ComposeResult:
        from day6_tui.textual_private.log_view import LogView

        self._log_view = LogView()
        yield self._log_view

    def on_resize(self) -> None:
        """Break the lines at the width that there is now."""
        view, width = self._log_view, max(10, self.size.width - FRAME)
        before, new = view.scroll_offset.y, not view.line_count
        lines = [part or " " for line in self._lines for part in wrap(line.replace("\t", "    "), width)]
        view.clear().write_lines(lines, scroll_end=new and not self._from_top)
        if not new:
            view.scroll_to(y=before, animate=False)

    @property
    def keyboard(self) -> Widget:
        return self._log_view
