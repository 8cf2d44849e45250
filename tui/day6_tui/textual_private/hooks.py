"""Methods of Textual's that are called where it has no message: the base classes of our application and overlays."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from textual import events
from textual.app import App
from textual.screen import ModalScreen

from day6_tui.textual_private.access import take_down

if TYPE_CHECKING:
    from rich.console import RenderableType
    from textual.notifications import Notification
    from textual.screen import Screen


class HookedApp(App[None]):
    """An application that is told of what it reads and displays, and of what fails in it."""

    def key_read(self) -> None:
        """Called when a key has been read and is about to be posted, in the thread that reads the terminal."""

    def displays(self) -> bool:
        """Whether anything is written to the terminal now."""
        return True

    def displayed(self, renderable: RenderableType | None) -> None:
        """Called after each frame, or part of one, with what was written."""

    def taken_down(self, box: Notification) -> None:
        """Called when a notification was clicked, or its time was over."""

    def _unnotify(self, notification: Notification, refresh: bool = True) -> None:
        take_down(self, notification)
        self.taken_down(notification)

    def failed(self, error: Exception) -> None:
        """Called where Textual would end with a traceback."""
        super()._handle_exception(error)

    def _handle_exception(self, error: Exception) -> None:
        self.failed(error)

    def _display(self, screen: Screen[Any], renderable: RenderableType | None) -> None:
        if self.displays():
            super()._display(screen, renderable)
            self.displayed(renderable)


class TypedAheadScreen(ModalScreen[None]):
    """An overlay whose first widget gets what was typed before it was there."""

    def __init__(self, *args: Any, **keywords: Any) -> None:
        super().__init__(*args, **keywords)
        self._early: list[events.Event] | None = []
        """What was typed before there was anything to type it into; None once there is."""

    def take_early_keys(self) -> None:
        """Hand over what came early; from now on it goes to what has the focus, as everywhere."""
        early, self._early = self._early or [], None
        for event in early:
            self._forward_event(event)

    def _forward_event(self, event: events.Event) -> None:
        typed = isinstance(event, (events.InputEvent, events.Paste)) and not isinstance(event, events.MouseEvent)
        if typed and self._early is not None:
            self._early.append(event)
        elif typed and self.focused is not None:
            self.focused._forward_event(event)
        else:
            super()._forward_event(event)
