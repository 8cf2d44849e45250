"""Methods of Textual's that are called where it has no message: the base classes of our application and overlays."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from rich.console import COLOR_SYSTEMS
from textual import events
from textual._compositor import CompositorUpdate
from textual.app import App
from textual.geometry import Region
from textual.message import Message
from textual.screen import ModalScreen

from day6_tui.screen.line import Line
from day6_tui.textual_private.access import take_down
from day6_tui.textual_private.drawing import Drawing

if TYPE_CHECKING:
    from rich.console import RenderableType
    from textual.notifications import Notification
    from textual.screen import Screen

SMALL = 200
"""Characters that a terminal reads at once, most often: they are not framed by sequences that cost as much as they."""


class HookedApp(App[None]):
    """An application that is told of what it reads and displays, and of what fails in it."""

    def __init__(self, *arguments: Any, **options: Any) -> None:
        super().__init__(*arguments, **options)
        self.line = Line()
        self.drawing = Drawing(self.line)
        self._is_small = False
        """Whether what is being displayed needs no asking that it be shown at once."""

    def key_read(self) -> None:
        """Called when a key has been read and is about to be posted, in the thread that reads the terminal."""

    def lets_in(self, message: Message) -> bool:
        """Whether what the terminal sent is taken; called in the thread that reads it."""
        return True

    def heard(self) -> None:
        """Called when the terminal has told how far it has read, in the thread that reads it."""

    def left_over(self) -> None:
        """Called when something of an update is not sent yet: it has to be drawn again."""

    def draw_anew(self) -> None:
        """Draw everything: something else has written to the terminal."""
        self.drawing.shown.forget()
        self.screen.refresh(layout=True)

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
        if not self.displays():
            return
        is_written = self._driver is not None and self._running and not self._closed and not self._batch_count
        if isinstance(renderable, CompositorUpdate) and is_written and not self.is_headless:
            renderable = self._prepared(screen, renderable)
        super()._display(screen, renderable)
        if renderable is not None:
            self.drawing.shown.cursor = self._previous_cursor_position
        self.displayed(renderable)

    def _begin_update(self) -> None:
        if not self._is_small:
            super()._begin_update()

    def _end_update(self) -> None:
        if not self._is_small:
            super()._end_update()
        self._is_small = False

    def _prepared(self, screen: Screen[Any], update: CompositorUpdate) -> CompositorUpdate | None:
        """What is sent of an update now; what is not stays to be drawn."""
        focused, size = screen.focused, screen.outer_size
        update, left = self.drawing.prepare(
            update,
            size,
            COLOR_SYSTEMS[self.console.color_system or "truecolor"],
            Region() if focused is None else focused.region,
            self.cursor_position,
        )
        self._is_small = len(update.render_segments(self.console)) < SMALL
        if left:
            screen._compositor._dirty_regions.update(left)
            self.left_over()
        return (
            update
            if update.spans or size.clamp_offset(self.cursor_position) != self._previous_cursor_position
            else None
        )


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
