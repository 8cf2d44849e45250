"""The line in which the expression of a field is typed, in its place in the list."""

from __future__ import annotations

from textual import events

from day6_tui.appearance.look import Look
from day6_tui.overlays.input_line import InputLine
from day6_tui.textual_private.survival import PersonMessage
from day6_tui.windows.fields.field_list import FieldLine


class FieldEntry(InputLine):
    """Enter takes the text over, Tab too and goes on in the next field, Esc leaves the old one; a click elsewhere is Enter."""

    DEFAULT_CSS = """
    FieldEntry.-textual-compact, FieldEntry.-textual-compact:focus {
        layer: entry; height: 1; padding: 0; border: none;
        background: $panel; background-tint: transparent 0%; color: $panel-strong;
    }
    """

    class Done(PersonMessage):
        """It is over: `text` is what was typed, None for Esc; `step` where to go on typing, 1 the next line, -1 the one above."""

        def __init__(self, entry: FieldEntry, text: str | None, step: int) -> None:
            super().__init__()
            self.entry, self.text, self.step = entry, text, step

    def __init__(self, look: Look, line: FieldLine, begun: str | None = None) -> None:
        super().__init__(look, line.typed if begun is None else begun)
        self.line = line
        self._is_old = begun is None
        self._over = False

    def on_mount(self) -> None:
        if self._is_old:
            self.select_all()  # what is typed replaces it

    def on_click(self, event: events.Click) -> None:
        """The second click of two, as on a cell of a table."""
        event.stop()
        if event.chain > 1:
            self.select_all()

    async def on_key(self, event: events.Key) -> None:
        if event.key == "escape":
            self.leave()
        elif event.key in ("tab", "shift+tab"):
            self._finish(self.value, -1 if event.key == "shift+tab" else 1)
        else:
            return  # to Line
        event.stop()
        event.prevent_default()

    def leave(self) -> None:
        """Leave what was there before."""
        self._finish(None)

    async def action_submit(self) -> None:
        """Enter."""
        self._finish(self.value)

    def on_blur(self) -> None:
        """Something else has got the keyboard, unless it is another window of the computer."""
        if self.app.app_focus:
            self._finish(self.value)

    def _finish(self, text: str | None, step: int = 0) -> None:
        if not self._over:
            self._over = True
            self.post_message(self.Done(self, text, step))
