"""The line in which a value of the Displays panel is typed, in its place in the tree."""

from __future__ import annotations

from collections.abc import Callable

from textual import events
from textual.widgets import Input

from day6_core.ros.programs.rviz2.model.properties import Property
from day6_tui.appearance.look import Look
from day6_tui.overlays.input_line import InputLine
from day6_tui.overlays.prompt import Taken


class ValueLine(InputLine):
    """Enter, Tab and a click elsewhere take the value over, Esc leaves the old one; `after` is called in each case."""

    DEFAULT_CSS = """
    DisplaysPanel > ValueLine.-textual-compact, DisplaysPanel > ValueLine.-textual-compact:focus {
        layer: value; height: 1; padding: 0; border: none;
        background: $panel; background-tint: transparent 0%; color: $panel-strong;
        &.-wrong { background: $error; color: $error-text; }
    }
    """

    def __init__(self, look: Look, prop: Property, taken: Taken, after: Callable[[], object]) -> None:
        super().__init__(look, prop.text)
        self.prop = prop
        self._taken = taken
        self._after = after
        self.over = False

    async def on_key(self, event: events.Key) -> None:
        if event.key == "escape":
            self._finish()
        elif event.key in ("tab", "shift+tab"):
            await self.action_submit()
        else:
            return  # to Line
        event.stop()
        event.prevent_default()

    def on_input_changed(self, event: Input.Changed) -> None:
        event.stop()
        self.remove_class("-wrong")

    async def action_submit(self) -> None:
        """Take the value over; a wrong one is explained, and the line stays open."""
        if not self.over and not self._is_wrong():
            self._finish()

    def on_blur(self) -> None:
        """Something else has got the keyboard, unless it is another window of the computer."""
        if self.app.app_focus and not self.over:
            self._is_wrong()
            self._finish()

    def _is_wrong(self) -> bool:
        complaint = self.value != self.prop.text and self._taken(self.value)
        self.set_class(bool(complaint), "-wrong")
        return bool(complaint)

    def _finish(self) -> None:
        self.over = True
        self._after()
