"""Keys of the teacher that go to something else than a terminal: to the pane that has the keyboard, or a menu of its window.

They take the way of the pupil's own keys, one by one, and each is looked at when its turn has come: the one before may have
opened something. None of them is a key of the desktop (`actions.bindings`), and none reaches a question: those are the pupil's.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import TYPE_CHECKING

from textual import events

from day6_tui.overlays.menu import Menu
from day6_tui.textual_private.keyboard import keys_in

if TYPE_CHECKING:
    from day6_tui.app import Day6App

_EDITING = ("enter", "escape", "tab", "shift+tab", "space", "backspace", "delete")
_MOVING = ("up", "down", "left", "right", "home", "end", "pageup", "pagedown")
PASSED = frozenset({*_EDITING, *_MOVING})
"""Besides what writes something."""


class TeachersKeys:
    """Those that are on their way. `may` says whether the teacher may type, `refuse` is told of a key that goes nowhere."""

    def __init__(self, app: Day6App, may: Callable[[], bool], refuse: Callable[[], None]) -> None:
        self._app = app
        self._may = may
        self._refuse = refuse
        self._coming: list[events.Event] = []

    def __contains__(self, event: events.Event) -> bool:
        return any(each is event for each in self._coming)

    @property
    def are_coming(self) -> bool:
        """Whether keys wait: what comes behind them has to take the same way."""
        return bool(self._coming)

    def type(self, text: str) -> None:
        """Have the keys that a terminal would send so arrive where the keyboard is."""
        for key in keys_in(text):
            if key.is_printable or key.key in PASSED:
                self._coming.append(key)
                self._app.post_message(key)
            else:
                self._refuse()

    def forget(self, event: events.Event) -> None:
        """It has arrived, or goes nowhere."""
        self._coming = [each for each in self._coming if each is not event]

    def may_pass(self, event: events.Event) -> bool:
        """Whether a key may go where the keyboard is now; the pupil's may."""
        if event not in self:
            return True
        self.forget(event)
        if self._may() and self.have_place():
            return True
        self._refuse()
        return False

    def have_place(self) -> bool:
        """Whether the keyboard is where the teacher may type, too."""
        desktop = self._app.desktop
        overlay = desktop.overlay
        if overlay is None:
            return desktop.focused_pane is not None
        return type(overlay) is Menu and overlay.about is not None
