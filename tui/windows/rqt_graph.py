"""rqt_graph's window: the laid-out graph, its controls as keys, a pulse on every edge along which messages pass."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import replace
from typing import Any

from rich.segment import Segment
from textual import events

from day6_tui.core.ros.programs.rqt_graph._content import GraphType, Options
from day6_tui.core.ros.programs.rqt_graph._drawing import ASCII, CONSOLE, UNICODE, Canvas, Glyphs, Run, draw, draw_pulse
from day6_tui.core.ros.programs.rqt_graph._fit import fitted
from day6_tui.core.ros.programs.rqt_graph._layout import Picture, Route
from day6_tui.core.ros.programs.rqt_graph._model import RqtGraph
from day6_tui.core.session.display import Window
from day6_tui.tui.cells import clip
from day6_tui.tui.look import Look
from day6_tui.tui.pane import Piece
from day6_tui.tui.windows import WindowPane

PULSE_SECONDS = 1.2
"""How long a pulse takes along an edge."""

PULSE_REST = 0.6
"""At least this long between two pulses on one edge: at 62 Hz one could not follow them."""

LOOK_SECONDS = 0.25
"""How often the message counters are read."""

_GLYPHS: dict[str, Glyphs] = {"half": UNICODE, "braille": UNICODE, "cell": CONSOLE, "ascii": ASCII}

_SWITCHES: dict[str, tuple[str, str]] = {
    "d": ("hide_debug", "Debug"),
    "s": ("hide_dead_sinks", "Dead sinks"),
    "l": ("hide_leaf_topics", "Leaf topics"),
    "p": ("hide_params", "Params"),
    "f": ("hide_tf", "tf"),
}
"""Key -> option and the label of rqt_graph's check box. A checked box hides."""

_SCROLL: dict[str, tuple[int, int]] = {
    "left": (-8, 0),
    "right": (8, 0),
    "up": (0, -1),
    "down": (0, 1),
    "pageup": (0, -10),
    "pagedown": (0, 10),
}


class RqtGraphPane(WindowPane):
    """Draws `RqtGraph.content`; keeps only what belongs to looking: scroll position and running pulses."""

    def __init__(self, window: Window, look: Look) -> None:
        super().__init__(window, look)
        self.graph: RqtGraph = window.model
        self._drawn: tuple[object, ...] = ()
        self._picture = Picture(0, 0, {}, ())
        self._canvas = Canvas(0, 0)
        self._rows: list[list[Run]] = []
        self._offset = (0, 0)
        self._counts: dict[str, int] = {}
        self._counted = 0.0
        self._pulses: dict[Route, float] = {}

    # -- frame ---------------------------------------------------------------------------------------------------------

    def title(self) -> list[Piece]:
        options = self.graph.options
        kind = Piece(
            f" {options.graph_type.value} {self.look.glyphs.chevron}", self.look.colours.muted, self._next_type
        )
        return [*super().title(), kind]

    def status(self) -> list[Piece]:
        hidden = self.graph.content.hidden
        count = sum(len(each.names) for each in hidden)
        if not count:
            return [Piece(f" {self.look.texts('rqt.nothing_hidden')} ", self.look.colours.muted)]
        separator = self.look.texts("rqt.separator")
        reasons = separator.join(
            self.look.texts("rqt.hides", option=each.option, names=", ".join(each.names)) for each in hidden
        )
        return [Piece(f" {self.look.texts('rqt.hidden', count=count)} {reasons} ", self.look.colours.muted)]

    def key_hints(self) -> list[tuple[str, str]]:
        return [
            ("t", self.look.texts("rqt.type")),
            ("d s l p f", self.look.texts("rqt.hide")),
            ("r", self.look.texts("rqt.refresh")),
        ]

    # -- content -------------------------------------------------------------------------------------------------------

    def pull(self, now: float) -> bool:
        size = (self.inner_width, self.inner_height)
        state = (self.graph.version, self.graph.options, size, self.look.glyphs.name, self.look.texts.language)
        if state != self._drawn:
            self._drawn = state
            self._lay_out()
            self.touch()
        return self._pull_pulses(now)

    def _lay_out(self) -> None:
        content = self.graph.content
        picture_height = max(1, self.inner_height - 1)
        ellipsis = self.look.glyphs.ellipsis
        self._picture = fitted(content.boxes, content.edges, self.inner_width, picture_height, ellipsis=ellipsis)
        self._pulses = {}
        self._paint()

    def _paint(self) -> None:
        glyphs = _GLYPHS[self.look.glyphs.canvas]
        self._canvas = draw(self._picture, glyphs, self.graph.content.trouble)
        for route, began in self._pulses.items():
            draw_pulse(self._canvas, route, (self._counted_now - began) / PULSE_SECONDS, glyphs)
        self._rows = self._canvas.rows()

    _counted_now = 0.0

    def _pull_pulses(self, now: float) -> bool:
        """Start pulses where counters moved, move the running ones; True while there is something to watch."""
        if self.look.reduced_motion:
            return False
        moved = False
        if now - self._counted >= LOOK_SECONDS:
            counts = self.graph.activity()
            for route in self._picture.routes:
                topic = route.edge.key
                fresh = counts.get(topic, 0) > self._counts.get(topic, counts.get(topic, 0))
                if fresh and now - self._pulses.get(route, -10.0) > PULSE_SECONDS + PULSE_REST:
                    self._pulses[route] = now
                    moved = True
            self._counts, self._counted = counts, now
        before = self._pulse_lines()
        self._counted_now = now
        running = {route: began for route, began in self._pulses.items() if now - began <= PULSE_SECONDS + PULSE_REST}
        if self._pulses or moved:
            self._pulses = running
            self._paint()
            top = self._top
            self.touch_lines(sorted({line + top for line in before | self._pulse_lines()}))
        return bool(self._pulses)

    def _pulse_lines(self) -> set[int]:
        return {y for route in self._pulses for _, y in route.cells}

    @property
    def _top(self) -> int:
        """The inside line of the picture's first row: it is centred while it fits."""
        spare = self.inner_height - 1 - self._picture.height
        return max(0, spare // 2) - (self._offset[1] if spare < 0 else 0)

    @property
    def _left(self) -> int:
        spare = self.inner_width - self._picture.width
        return max(0, spare // 2) - (self._offset[0] if spare < 0 else 0)

    def content_line(self, y: int, width: int) -> Iterable[Segment]:
        if y == self.inner_height - 1:
            return self._switch_line(width)
        if not self.graph.content.boxes and y == self.inner_height // 2:
            text = clip(self.look.texts("rqt.empty"), width, self.look.glyphs.ellipsis)
            return [Segment(text, self.look.colours.muted)]
        row = y - self._top
        if not 0 <= row < len(self._rows):
            return ()
        left = self._left
        segments = [Segment(" " * left, self.background)] if left > 0 else []
        skip = max(0, -left)
        for text, style in self._rows[row]:
            if skip >= len(text):
                skip -= len(text)
                continue
            segments.append(Segment(text[skip:], self._style(style)))
            skip = 0
        return segments

    def _style(self, name: str):  # type: ignore[no-untyped-def]
        colours = self.look.colours
        table = {
            "node": colours.node,
            "topic": colours.topic,
            "group": colours.topic,
            "label": colours.topic,
            "edge": colours.muted,
            "pulse": colours.accent,
            "warning": colours.warning,
        }
        return table.get(name, self.background)

    def _switch_line(self, width: int) -> list[Segment]:
        """Trouble with QoS or types first, else the check boxes."""
        colours, options = self.look.colours, self.graph.options
        if self.graph.content.trouble:
            topic, lines = next(iter(self.graph.content.trouble.items()))
            text = f"{self.look.glyphs.warning} {topic.strip()}: {' '.join(lines[:2])}"
            return [Segment(clip(text, width, self.look.glyphs.ellipsis), colours.warning)]
        segments = [Segment(f"{self.look.texts('rqt.hide')}: ", colours.muted)]
        for key, (option, label) in _SWITCHES.items():
            mark = "x" if getattr(options, option) else " "
            segments.append(Segment(f"[{mark}] ", colours.muted))
            segments.append(Segment(f"{label}({key})  ", colours.text if mark == "x" else colours.muted))
        return segments

    # -- keys ----------------------------------------------------------------------------------------------------------

    def on_key(self, event: events.Key) -> None:
        key = event.key
        if key in _SWITCHES:
            option = _SWITCHES[key][0]
            switched: dict[str, Any] = {option: not getattr(self.graph.options, option)}
            self._change(replace(self.graph.options, **switched))
        elif key == "t":
            self._next_type()
        elif key == "r":
            self.graph.request_refresh()
        elif key == "a":
            self.graph.auto_refresh = not self.graph.auto_refresh
        elif key in _SCROLL:
            self._scroll(*_SCROLL[key])
        else:
            return
        event.stop()
        event.prevent_default()

    def on_mouse_scroll_down(self, event: events.MouseScrollDown) -> None:
        self._scroll(0, 2)
        event.stop()

    def on_mouse_scroll_up(self, event: events.MouseScrollUp) -> None:
        self._scroll(0, -2)
        event.stop()

    def _change(self, options: Options) -> None:
        self.graph.change_options(options)
        self.pull(self._counted_now)

    def _next_type(self) -> None:
        kinds = list(GraphType)
        following = kinds[(kinds.index(self.graph.options.graph_type) + 1) % len(kinds)]
        self._change(replace(self.graph.options, graph_type=following))

    def _scroll(self, columns: int, rows: int) -> None:
        x = min(max(0, self._offset[0] + columns), max(0, self._picture.width - self.inner_width))
        y = min(max(0, self._offset[1] + rows), max(0, self._picture.height - self.inner_height + 1))
        if (x, y) != self._offset:
            self._offset = (x, y)
            self.touch()
