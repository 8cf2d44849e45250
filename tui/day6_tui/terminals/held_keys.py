"""Keys that a user presses while a scene types into the same terminal."""

from __future__ import annotations

from collections.abc import Callable
from typing import TYPE_CHECKING

from textual import events

if TYPE_CHECKING:
    from day6_tui.terminals.view import TerminalView


class HeldKeys:
    """Holds back keys for the terminal in which a scene types, until it has finished; Esc stops the scene."""

    def __init__(self) -> None:
        self.holding = False
        self.view: TerminalView | None = None
        """The terminal the scene types in; None before it has chosen one, when every key is held."""
        self.keys: list[events.Key] = []
        self.paused = False
        """Whether the scene is paused: keys go to the terminal then, also to the scene's own."""
        self.steer: Callable[[str], bool] = lambda key: False
        """Takes a key that steers the scene; such a key is one only while nothing was typed ahead."""

    def begin(self) -> None:
        """A scene begins."""
        self.holding, self.view, self.keys, self.paused = True, None, [], False

    def end(self) -> None:
        """It has ended; what is held is forgotten."""
        self.holding, self.view, self.keys, self.paused = False, None, [], False

    def take(self, event: events.Key, view: TerminalView | None) -> bool:
        """Keep a key for `view`; False if it has to go there now."""
        if not self.holding or (self.view is not None and view is not self.view):
            return False
        if event.key == "escape":
            self.end()
        elif not self.keys and self.steer(event.key):
            return True
        elif self.paused:
            return False
        else:
            self.keys.append(event)
        return True
