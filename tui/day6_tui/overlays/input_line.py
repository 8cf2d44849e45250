"""The line to type in: Textual's Input, for people whose fingers are faster than the machine."""

from __future__ import annotations

from typing import Any

from rich.highlighter import Highlighter
from rich.text import Text
from textual import events
from textual.widgets import Input

from day6_core.session.harmless import same_length
from day6_tui.appearance.look import Look
from day6_tui.overlays.modal import Modal
from day6_tui.screen.key_order import is_letter
from day6_tui.textual_private.access import run_binding
from day6_tui.textual_private.survival import Surviving


class _Harmless(Highlighter):
    """Shows what is typed and pasted without the sequences in it, which the user's terminal would obey."""

    def __init__(self, look: Look) -> None:
        self._look = look

    def highlight(self, text: Text) -> None:
        """Put a picture in the place of each harmful character."""
        text.plain = same_length(text.plain, pictures=self._look.glyphs.chinese)


class InputLine(Surviving, Input):
    """An Input whose keys take effect in the order in which they were typed, however many wait.

    Textual lets the bindings of a key run after it has travelled from the Input up to the application, while letters are taken
    at once: of `a`, Backspace, `b` in one burst it would make nothing.
    """

    def __init__(self, look: Look, value: str = "", *, placeholder: str = "") -> None:
        super().__init__(value, placeholder, highlighter=_Harmless(look), compact=True, select_on_focus=False)
        self.cursor_blink = False
        self._look = look

    def keeps_keyboard(self, event: events.Event) -> bool:
        return is_letter(event)

    async def on_key(self, event: events.Key) -> None:
        if not event.is_printable:
            event.stop()
            event.prevent_default()
            await run_binding(self.app, event.key)

    def on_paste(self, event: events.Paste) -> None:
        """All words of what is pasted, which may be several lines, in one."""
        event.stop()
        event.prevent_default()
        self.replace(" ".join(event.text.split()), *self.selection)

    async def action_submit(self) -> None:
        """Enter."""
        screen: Any = self.screen
        if isinstance(screen, Modal):
            screen.accept()

    def action_delete_right(self) -> None:
        """Del, which means something else at the end of the line."""
        if self.cursor_position < len(self.value) or not isinstance(self.screen, Modal):
            super().action_delete_right()
        else:
            self.screen.delete()
