"""The picture of a cast at a time: the emulation of our own terminals, fed up to there."""

from __future__ import annotations

from day6_core.shell.screen.rows import Run, runs_of
from day6_core.shell.screen.screen import Screen
from day6_tui.cast.file import Cast

Rows = list[tuple[Run, ...]]
"""The lines of a screen as runs of one style."""


class Film:
    """A cast and a place in it."""

    def __init__(self, cast: Cast) -> None:
        self.cast = cast
        self._rewind()

    def _rewind(self) -> None:
        self._screen = Screen(*self.cast.size)
        self._next = 0

    @property
    def size(self) -> tuple[int, int]:
        """Columns and rows of the picture now."""
        return self._screen.columns, self._screen.lines

    def go_to(self, seconds: float) -> bool:
        """Show the picture at a time after the beginning; return whether anything was fed, so that it may differ."""
        events = self.cast.events
        if self._next and events[self._next - 1].time > seconds:
            self._rewind()
        began = self._next
        while self._next < len(events) and events[self._next].time <= seconds:
            event = events[self._next]
            self._next += 1
            if event.kind == "r":
                self._screen.resize(event.size[1], event.size[0])
            else:
                self._screen.feed(event.text)
                self._screen.answers.clear()
        return self._next != began

    @property
    def next_time(self) -> float | None:
        """When the next event is, None after the last one."""
        events = self.cast.events
        return events[self._next].time if self._next < len(events) else None

    def rows(self) -> Rows:
        """What the screen shows."""
        return [runs_of(self._screen.row(y)) for y in range(self._screen.lines)]
