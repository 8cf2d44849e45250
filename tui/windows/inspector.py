"""The inspector's window: what is wrong with the graph, the worst first, in the user's language."""

from __future__ import annotations

from collections.abc import Iterable

from rich.segment import Segment
from textual import events

from day6_tui.core.ros.programs.day6_inspector.model import Inspector
from day6_tui.core.session.display import Window
from day6_tui.tui.cells import wrap
from day6_tui.tui.look import Look
from day6_tui.tui.pane import Piece
from day6_tui.tui.windows import WindowPane

_SCROLL = {"down": 1, "up": -1, "pagedown": 8, "pageup": -8, "home": -9999, "end": 9999}


class InspectorPane(WindowPane[Inspector]):
    """Draws `Inspector.findings`, wrapped."""

    def __init__(self, window: Window[Inspector], look: Look) -> None:
        super().__init__(window, look)
        self.inspector = window.model
        self._drawn: tuple[object, ...] = ()
        self._lines: list[list[Segment]] = []
        self._first = 0

    @property
    def label(self) -> str:
        return self.look.texts("inspector.title")

    def status(self) -> list[Piece]:
        errors = sum(finding.level == "error" for finding in self.inspector.findings)
        text = self.look.texts("inspector.count", errors=errors, all=len(self.inspector.findings))
        return [Piece(f" {text} ", self.look.colours.warning if errors else self.look.colours.muted)]

    def pull(self, now: float) -> bool:
        state = (self.inspector.version, self.inner_width, self.look.texts.language, self.look.colours.name)
        if state != self._drawn:
            self._drawn = state
            self._lines = list(self._build(self.inner_width))
            self._scroll(0)
            self.touch()
        return False

    def _build(self, width: int) -> Iterable[list[Segment]]:
        colours, texts, glyphs = self.look.colours, self.look.texts, self.look.glyphs
        if not self.inspector.findings:
            yield [Segment(f" {texts('inspector.well')}", colours.publisher)]
            return
        marks = {
            "error": (glyphs.warning, colours.warning),
            "warning": (glyphs.warning, colours.text),
            "info": (glyphs.dot, colours.muted),
        }
        for finding in self.inspector.findings:
            mark, style = marks[finding.level]
            text = texts(finding.id, **dict(finding.parameters))
            for number, line in enumerate(wrap(text, max(10, width - 4))):
                yield [Segment(f" {mark if number == 0 else ' '} ", style), Segment(line, style)]

    def content_line(self, y: int, width: int) -> Iterable[Segment]:
        index = y + self._first
        return self._lines[index] if index < len(self._lines) else ()

    def on_key(self, event: events.Key) -> None:
        step = _SCROLL.get(event.key)
        if step is not None:
            self._scroll(step)
            event.stop()
            event.prevent_default()

    def on_mouse_scroll_down(self, event: events.MouseScrollDown) -> None:
        event.stop()
        self._scroll(2)

    def on_mouse_scroll_up(self, event: events.MouseScrollUp) -> None:
        event.stop()
        self._scroll(-2)

    def _scroll(self, lines: int) -> None:
        first = max(0, min(self._first + lines, len(self._lines) - self.inner_height))
        if first != self._first:
            self._first = first
            self.touch()
