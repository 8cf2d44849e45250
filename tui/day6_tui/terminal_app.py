"""Base of the applications on a terminal: input that survives errors, Textual's screen as ours are drawn, poor terminals."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import Any

from textual import events
from textual.driver import Driver
from textual.filter import LineFilter
from textual.geometry import Size
from textual.screen import Screen
from textual.widget import Widget

from day6_tui.pixels.app import PictureApp
from day6_tui.screen.key_order import KeyOrder
from day6_tui.screen.poor_terminals import filters_for
from day6_tui.screen.survival import survive
from day6_tui.textual_private.frame_screen import FrameScreen
from day6_tui.textual_private.keyboard import sturdy

WAITING_OUTPUT = 3
"""Number of writes still waiting for the terminal at which the next frame is postponed."""


class DeskScreen(FrameScreen):
    """Textual's screen, whose own background is never seen."""

    BLANK = True
    ALLOW_SELECT = False  # terminals have their own selection; Textual's fails on a widget that is just being removed

    def _refresh_layout(self, size: Size | None = None, scroll: bool = False) -> None:
        """Lay the panes out. Textual 8.2 then stops its timer, also when something else still waits for it."""
        super()._refresh_layout(size, scroll)
        self.check_idle()

    def _compositor_refresh(self) -> None:
        """Draw, or hand on what has changed to the modal screen through which it is seen.

        Textual 8.2 marks this screen as changed too in that case, and so would send the same picture again and again.
        """
        changed = self._compositor._dirty_regions
        if self.app.screen is self or not changed:
            super()._compositor_refresh()
            return
        self.app.screen.refresh(*changed)
        changed.clear()
        self._dirty_widgets.clear()


class TerminalApp(PictureApp):
    """An application with a `look`."""

    def __init__(self, *arguments: Any, **options: Any) -> None:
        super().__init__(*arguments, **options)
        self._key_order = KeyOrder(self.keyboard, self._hand_over)

    async def on_event(self, event: events.Event) -> None:
        if isinstance(event, (events.Key, events.Paste)) and not event.is_forwarded:
            await self._key_order.take(event)
        else:
            await survive(self, event, super().on_event(event))

    def keyboard(self) -> Widget:
        """Return what gets the next key."""
        return self.focused or self.screen

    async def _hand_over(self, event: events.Event) -> None:
        if not self._exit:  # while leaving, there is nothing left to receive keys
            await survive(self, event, super().on_event(event))

    def get_driver_class(self) -> type[Driver]:
        return sturdy(super().get_driver_class())

    def get_default_screen(self) -> Screen[Any]:
        return DeskScreen(id="_default")

    def draw_in_frame(self, pull: Callable[[], bool]) -> bool:
        """Let panes pull what is new and draw it at once; returns what `pull` does."""
        screen = self.screen
        if not isinstance(screen, FrameScreen):
            return pull()
        screen.begin_frame()
        try:
            return pull()
        finally:
            screen.end_frame()

    def get_line_filters(self) -> Sequence[LineFilter]:
        return [*super().get_line_filters(), *filters_for(self.look)]

    def is_congested(self) -> bool:
        """Whether the terminal takes less than it is sent."""
        writer = getattr(self._driver, "_writer_thread", None)
        queue = getattr(writer, "_queue", None)
        return queue is not None and queue.qsize() > WAITING_OUTPUT
