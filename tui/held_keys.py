"""Keys that a user presses while a scene types into the same terminal."""

from __future__ import annotations

from typing import TYPE_CHECKING

from textual import events

if TYPE_CHECKING:
    from day6_tui.tui.terminal_view import TerminalView


class HeldKeys:
    """Holds back keys for the terminal in which a scene types, until it has finished; Esc stops the scene."""

    def __init__(self) -> None:
        self.holding = False
        self.view: TerminalView | None = None
        """The terminal the scene types in; None before it has chosen one, when every key is held."""
        self.keys: list[events.Key] = []

    def begin(self) -> None:
        """A scene begins."""
        self.holding, self.view, self.keys = True, None, []

    def end(self) -> None:
        """It has ended; what is held is forgotten."""
        self.holding, self.view, self.keys = False, None, []

    def take(self, event: events.Key, view: TerminalView | None) -> bool:
        """Keep a key for `view`; False if it has to go there now."""
        if not self.holding or (self.view is not None and view is not self.view):
            return False
        if event.key == "escape":
            self.end()
        else:
            self.keys.append(event)
        return True
