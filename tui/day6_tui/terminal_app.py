"""Base of the applications on a terminal: input that survives errors, Textual's screen as ours are drawn, poor terminals."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import Any

from textual import events
from textual.driver import Driver
from textual.filter import LineFilter
from textual.screen import Screen
from textual.widget import Widget

from day6_tui import textual_private
from day6_tui.pixels.app import PictureApp
from day6_tui.screen.frames import Frames
from day6_tui.screen.key_order import KeyOrder
from day6_tui.screen.poor_terminals import filters_for
from day6_tui.textual_private.access import ask_terminal, draw_rest, is_leaving, waiting_writes
from day6_tui.textual_private.drawing import FOR_KEYS
from day6_tui.textual_private.frame_screen import DeskScreen, FrameScreen
from day6_tui.textual_private.keyboard import sturdy
from day6_tui.textual_private.survival import Surviving

textual_private.install()

WAITING_OUTPUT = 3
"""Number of writes still waiting for the terminal at which the next frame is postponed."""
LEAST_ROOM = 0.5
"""What is under way to a slow terminal when the next frame comes, as a share of what may be."""


class TerminalApp(Surviving, PictureApp):
    """An application with a `look` and `frames`."""

    frames: Frames

    def __init__(self, *arguments: Any, **options: Any) -> None:
        super().__init__(*arguments, **options)
        self._key_order = KeyOrder(self.keyboard, self._hand_over)

    def echoes_keys(self) -> bool:
        """Whether what is typed now comes back from a program."""
        return False

    def key_read(self) -> None:
        self.frames.typed()

    async def on_event(self, event: events.Event) -> None:
        if isinstance(event, (events.Key, events.Paste)) and not event.is_forwarded:
            self.frames.hurry(echoes=self.echoes_keys())
            if isinstance(event, events.Key) and event.key == "ctrl+l":
                self.draw_anew()  # besides what it does in a terminal: another program may have written to the screen
            await self._key_order.take(event)
        else:
            await super().on_event(event)

    def keyboard(self) -> Widget:
        """Return what gets the next key."""
        return self.focused or self.screen

    async def _hand_over(self, event: events.Event) -> None:
        if not is_leaving(self):  # while leaving, there is nothing left to receive keys
            await super().on_event(event)

    def get_driver_class(self) -> type[Driver]:
        return sturdy(super().get_driver_class())

    def get_default_screen(self) -> Screen[Any]:
        return DeskScreen(id="_default")

    def draw_in_frame(self, pull: Callable[[], bool]) -> bool:
        """Let panes pull what is new and draw it at once; returns what `pull` does."""
        screen = self.screen
        if not isinstance(screen, FrameScreen):
            again = pull()
            draw_rest(screen)
            return again
        screen.begin_frame()
        try:
            return pull()
        finally:
            screen.end_frame()

    def draw_alone(self, pull: Callable[[], object]) -> bool:
        """Draw at once what `pull` has a pane take over, and nothing else; returns whether that was anything."""
        screen = self.screen
        if not isinstance(screen, FrameScreen):
            return False
        screen.begin_frame()
        try:
            pull()
        finally:
            drawn = screen.end_frame()
        return drawn

    def get_line_filters(self) -> Sequence[LineFilter]:
        return [*super().get_line_filters(), *filters_for(self.look)]

    def is_congested(self) -> bool:
        """Whether the terminal takes less than it is sent."""
        lacks = self._lacks(LEAST_ROOM)
        if lacks and self.line.may_ask and not self.line.waits:
            ask_terminal(self)  # its answer lets the next frame come
        return lacks

    def is_blocked(self) -> bool:
        """Whether not even the echo of a key could be sent."""
        return self._lacks(FOR_KEYS)

    def _lacks(self, share: float) -> bool:
        room = self.line.room(share)
        return (room is not None and room <= 0) or waiting_writes(self) > WAITING_OUTPUT

    def left_over(self) -> None:
        self.frames.hold()
        self.frames.wake()

    def heard(self) -> None:
        self.frames.relieve()
