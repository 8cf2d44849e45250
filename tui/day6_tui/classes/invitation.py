"""How pupils join: the command to read out, to write on the board, or to copy into a message."""

from __future__ import annotations

from textual.app import ComposeResult
from textual.binding import Binding
from textual.content import Content

from day6_tui.appearance.look import Look
from day6_tui.overlays.modal import Modal, lines_of, plain


class Invitation(Modal):
    """Shows `command`; Enter copies it."""

    BINDINGS = [Binding("enter,c", "copy", show=False), Binding("i,q", "close", show=False)]

    def __init__(self, look: Look, text: str, command: str) -> None:
        super().__init__(look, look.texts("teacher.invite"), look.texts("teacher.invite.keys"))
        self._text = text
        self._command = command

    def inside(self) -> ComposeResult:
        from textual.widgets import Static

        yield Static(Content("\n").join(lines_of(self._text)), classes="text")
        yield Static(plain(self._command), classes="text", id="command")
        self._note: Static = Static("", classes="note")
        yield self._note

    def action_copy(self) -> None:
        """Give the command to the clipboard of the terminal."""
        self.app.copy_to_clipboard(self._command)
        self._note.update(plain(self.look.texts("terminal.copied")))
