"""One line to type: a filter, a file name, a number. Esc leaves everything as it was."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path

from textual.app import ComposeResult
from textual.widget import Widget

from day6_tui.appearance.look import Look
from day6_tui.overlays.modal import Modal, plain

Taken = Callable[[str], str | None]
"""Receives the typed text; returns what is wrong with it (then the prompt stays open), or None."""


def before_replacing(look: Look, path_of: Callable[[str], Path], taken: Taken) -> Taken:
    """Wrap `taken` for a file name to save under: if the file exists, Enter has to be pressed again."""
    asked = ""

    def checked(text: str) -> str | None:
        nonlocal asked
        path = path_of(text)
        if asked != text and path.is_file():
            asked = text
            return look.texts("prompt.replaces", file=path.name)
        return taken(text)

    return checked


class Prompt(Modal):
    """Asks for `title`; `note` is shown below the line until `taken` returns a complaint."""

    def __init__(self, look: Look, title: str, value: str, taken: Taken, *, note: str = "") -> None:
        super().__init__(look, title, look.texts("prompt.keys"))
        self._value = value
        self._taken = taken
        self._note_text = note

    def inside(self) -> ComposeResult:
        from textual.widgets import Static

        from day6_tui.overlays.input_line import InputLine

        self._line = InputLine(self.look, self._value)
        yield self._line
        self._note = Static(plain(self._note_text), classes="note")
        yield self._note

    @property
    def keyboard(self) -> Widget:
        return self._line

    def on_input_changed(self) -> None:
        self._say(self._note_text, complaint=False)

    def accept(self) -> None:
        """Enter: close, unless something is wrong with the text."""
        if not self.is_active:
            return
        complaint = self._taken(self._line.value)
        if complaint:
            self._say(complaint, complaint=True)
        else:
            self.close()

    def _say(self, text: str, *, complaint: bool) -> None:
        self._note.update(plain(text))
        self._note.set_class(complaint, "complaint")
