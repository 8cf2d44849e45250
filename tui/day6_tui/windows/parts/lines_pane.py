"""A window of lines that are made whole, and of which only those that have changed are drawn anew."""

from __future__ import annotations

from abc import abstractmethod
from collections.abc import Iterable
from typing import Any

from rich.segment import Segment
from textual import events

from day6_core.session.display import Model, Window
from day6_tui.appearance.look import Look
from day6_tui.windows import WindowPane

Line = list[Segment]


class LinesPane(WindowPane[Model]):
    """Shows what `_build` makes, anew when the model's `version` has changed. A subclass calls `_redraw` when it has itself."""

    def __init__(self, window: Window[Model], look: Look) -> None:
        super().__init__(window, look)
        self._version = -1
        self._shown: list[Line] = []

    @abstractmethod
    def _build(self, width: int, height: int) -> list[Line]:
        """Make all lines of the inside."""

    def pull(self, now: float) -> bool:
        model: Any = self.model
        if model.version != self._version or len(self._shown) != self.inner_height:
            self._show()
        return False

    def _lines(self, width: int, height: int) -> list[Line]:
        model: Any = self.model
        self._version = model.version  # before it is read: what changes meanwhile is shown next time
        return self._build(width, height)

    def _show(self) -> None:
        before, self._shown = self._shown, self._lines(self.inner_width, self.inner_height)
        if len(before) != len(self._shown):
            super().touch()
        else:
            self.touch_lines(y for y, (old, new) in enumerate(zip(before, self._shown, strict=True)) if old != new)
            self.touch_frame()

    def _redraw(self) -> None:
        self._show()
        self.look.wake()

    def touch(self) -> None:
        self._shown = []
        super().touch()

    def on_resize(self, event: events.Resize) -> None:
        super().on_resize(event)
        self._shown = []

    def content_line(self, y: int, width: int) -> Iterable[Segment]:
        if len(self._shown) != self.inner_height:
            self._shown = self._lines(width, self.inner_height)
        return self._shown[y] if y < len(self._shown) else ()
