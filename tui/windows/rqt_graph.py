"""rqt_graph's window: the laid-out graph, its controls as keys, a pulse on every edge along which messages pass."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import replace
from functools import partial

from rich.segment import Segment
from textual import events

from day6_tui.core.ros.programs.rqt_graph.model.content import Options
from day6_tui.core.ros.programs.rqt_graph.model.drawing import (
    ASCII,
    CONSOLE,
    UNICODE,
    Canvas,
    Glyphs,
    Highlight,
    Run,
    draw,
    draw_pulse,
)
from day6_tui.core.ros.programs.rqt_graph.model.fit import fitted, unfitted
from day6_tui.core.ros.programs.rqt_graph.model.rqt_graph import RqtGraph
from day6_tui.core.ros.programs.rqt_graph.model.shapes import Picture, Route
from day6_tui.core.session.display import Window
from day6_tui.tui.cells import cell_len, clip
from day6_tui.tui.look import Look
from day6_tui.tui.pane import Piece
from day6_tui.tui.prompt import before_replacing
from day6_tui.tui.windows import WindowPane
from day6_tui.tui.windows.rqt_graph_options import (
    GROUP,
    HIDE,
    NAMESPACES,
    SWITCHES,
    VIEW,
    Control,
    flowing,
    switched,
)

PULSE_SECONDS = 1.2
"""How long a pulse takes along an edge."""

PULSE_REST = 0.6
"""Minimum time between two pulses on one edge: at 62 Hz the eye could not follow them."""

LOOK_SECONDS = 0.25
"""How often the message counters are read."""

_GLYPHS: dict[str, Glyphs] = {"half": UNICODE, "braille": UNICODE, "cell": CONSOLE, "ascii": ASCII}

_SCROLL: dict[str, tuple[int, int]] = {
    "left": (-8, 0),
    "right": (8, 0),
    "up": (0, -1),
    "down": (0, 1),
    "pageup": (0, -10),
    "pagedown": (0, 10),
}


class RqtGraphPane(WindowPane[RqtGraph]):
    """Draws `RqtGraph.content`; keeps only view state: scroll position and running pulses."""

    def __init__(self, window: Window[RqtGraph], look: Look) -> None:
        super().__init__(window, look)
        self.graph = window.model
        self._drawn: tuple[object, ...] = ()
        self._picture = Picture(0, 0, {}, ())
        self._canvas = Canvas(0, 0)
        self._rows: list[list[Run]] = []
        self._offset = (0, 0)
        self._counts: dict[str, int] = {}
        self._counted = 0.0
        self._pulses: dict[Route, float] = {}
        self._controls: list[list[Control]] = []
        self._controls_for: object = None
        self._chosen = ""
        """Key of the box whose edges are highlighted, '' for none."""

    # -- frame ---------------------------------------------------------------------------------------------------------

    def title(self) -> list[Piece]:
        options = self.graph.options
        text = self.graph.loaded or f"{options.graph_type.value} {self.look.glyphs.chevron}"
        return [*super().title(), Piece(f" {text}", self.look.colours.muted, lambda: self._switch("t"))]

    def status(self) -> list[Piece]:
        if self.graph.loaded:
            return [Piece(f" {self.look.texts('rqt.loaded', name=self.graph.loaded)} ", self.look.colours.muted)]
        if self._chosen:
            return [Piece(f" {self._about_chosen()} ", self.look.colours.text)]
        hidden = self.graph.content.hidden
        count = sum(len(each.names) for each in hidden)
        if not count:
            return [Piece(f" {self.look.texts('rqt.nothing_hidden')} ", self.look.colours.muted)]
        separator = self.look.texts("rqt.separator")
        reasons = separator.join(
            self.look.texts("rqt.hides", option=each.option, names=", ".join(each.names)) for each in hidden
        )
        return [Piece(f" {self.look.texts('rqt.hidden', count=count, reasons=reasons)} ", self.look.colours.muted)]

    def key_hints(self) -> list[tuple[str, str]]:
        return [
            ("t", self.look.texts("rqt.type")),
            ("d s l p f u", self.look.texts("rqt.hide")),
            ("j k", self.look.texts("rqt.choose")),
        ]

    def more_key_hints(self) -> list[tuple[str, str]]:
        return [
            ("/ :", self.look.texts("rqt.filter")),
            ("n", self.look.texts("rqt.namespaces")),
            ("1 2 3", self.look.texts("rqt.group")),
            ("h v", self.look.texts("rqt.view")),
            ("w o", self.look.texts("rqt.files")),
            ("r", self.look.texts("rqt.refresh")),
            ("a", self.look.texts("rqt.auto")),
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
        if self.graph.options.fit:
            height = max(1, self.inner_height - self._switch_rows())
            ellipsis = self.look.glyphs.ellipsis
            self._picture = fitted(content.boxes, content.edges, self.inner_width, height, ellipsis=ellipsis)
        else:
            self._picture = unfitted(content.boxes, content.edges)
        if self._chosen not in self._picture.boxes:
            self._chosen = ""
        self._pulses = {}
        self._scroll(0, 0)
        self._paint()

    def _paint(self) -> None:
        glyphs = _GLYPHS[self.look.glyphs.canvas]
        highlight = Highlight(self._chosen, self.graph.content.edges) if self._chosen else None
        self._canvas = draw(self._picture, glyphs, self.graph.content.trouble, highlight)
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
        spare = self.inner_height - self._switch_rows() - self._picture.height
        return max(0, spare // 2) - (self._offset[1] if spare < 0 else 0)

    @property
    def _left(self) -> int:
        spare = self.inner_width - self._picture.width
        return max(0, spare // 2) - (self._offset[0] if spare < 0 else 0)

    def content_line(self, y: int, width: int) -> Iterable[Segment]:
        below = y - self.inner_height + self._switch_rows()
        if below >= 0:
            return self._switch_line(below, y, width)
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
            "cluster": colours.frame,
            "pulse": colours.accent,
            "warning": colours.warning,
            "chosen": colours.choice,
            "incoming": colours.publisher,
            "outgoing": colours.accent,
            "faded": colours.frame,
        }
        return table.get(name, self.background)

    def _switch_rows(self) -> int:
        """Lines for the check boxes: those that hide and, if there is room, those that group."""
        return len(self._switch_lines(self.inner_width))

    def _switch_lines(self, width: int) -> list[list[Control]]:
        """The check boxes as they flow into lines, at most a fifth of the window."""
        texts, most = self.look.texts, max(1, self.inner_height // 5)
        state = (self.graph.options, width, most, texts.language)
        if state == self._controls_for:
            return self._controls
        lines = flowing(texts("list.head", name=texts("rqt.hide")), HIDE, self.graph.options, width)
        group = texts("list.head", name=texts("rqt.group"))
        more = flowing(group, (NAMESPACES, *GROUP, *VIEW), self.graph.options, width)
        self._controls_for = state
        self._controls = [*lines, *more] if len(lines) + len(more) <= most else lines[:most]
        return self._controls

    def _switch_line(self, row: int, y: int, width: int) -> list[Segment]:
        """Trouble with QoS or types first, else the check boxes; a click on one is its key."""
        colours = self.look.colours
        trouble = self.graph.content.trouble
        if trouble and row == 0:
            topic = self._chosen if self._chosen in trouble else next(iter(trouble))
            text = f"{self.look.glyphs.warning} {topic.strip()}: {' '.join(trouble[topic])}"
            return [Segment(clip(text, width, self.look.glyphs.ellipsis), colours.warning)]
        segments = []
        x = 1
        for control in self._switch_lines(width)[row]:
            end = x + cell_len(control.text)
            if control.key:
                self.add_hit(y + 1, x, end, partial(self._switch, control.key))
            segments.append(Segment(control.text, colours.text if control.on else colours.muted))
            x = end
        return segments

    def _about_chosen(self) -> str:
        """Describe in one line the edges of the chosen box."""
        box, _ = self._picture.boxes[self._chosen]
        edges = self.graph.content.edges
        arriving = [edge for edge in edges if edge.end == self._chosen]
        leaving = [edge for edge in edges if edge.start == self._chosen]
        key = "rqt.node" if box.shape == "node" else "rqt.topic"
        return self.look.texts(key, name=box.lines[0], arriving=len(arriving), leaving=len(leaving))

    # -- keys ----------------------------------------------------------------------------------------------------------

    def on_key(self, event: events.Key) -> None:
        key = event.character if event.character in ("/", ":") else event.key
        if key in SWITCHES or key in ("t", "n"):
            self._switch(key)
        elif key == "r":
            self.graph.request_refresh()
        elif key == "a":
            self.graph.auto_refresh = not self.graph.auto_refresh
            if self.graph.auto_refresh:
                self.graph.request_refresh()
        elif key in ("j", "k"):
            self._choose_next(1 if key == "j" else -1)
        elif key == "escape" and self._chosen:
            self._choose("")
        elif key in ("/", ":"):
            self._ask_filter("node_filter" if key == "/" else "topic_filter")
        elif key in ("w", "o"):
            self._ask_file(saving=key == "w")
        elif key in _SCROLL:
            self._scroll(*_SCROLL[key])
        else:
            return
        event.stop()
        event.prevent_default()

    def on_click(self, event: events.Click) -> None:
        """A click on a box chooses it; a click elsewhere chooses none."""
        if self.hit(event.x, event.y) is not None:
            super().on_click(event)
            return
        x, y = event.x - 1 - self._left, event.y - 1 - self._top
        for key, (_, rect) in self._picture.boxes.items():
            if rect.x <= x < rect.x + rect.width and rect.y <= y < rect.y + rect.height:
                self._choose("" if key == self._chosen else key)
                return
        self._choose("")

    def _switch(self, key: str) -> None:
        self._change(switched(self.graph.options, key))

    def _choose_next(self, step: int) -> None:
        """Choose the next box: column by column, from above."""
        places = sorted(
            self._picture.boxes, key=lambda key: (lambda rect: (rect.x, rect.y))(self._picture.boxes[key][1])
        )
        if places:
            at = places.index(self._chosen) + step if self._chosen in places else (0 if step > 0 else -1)
            self._choose(places[at % len(places)])

    def _choose(self, key: str) -> None:
        if not self.graph.options.highlight:
            key = ""
        if key != self._chosen:
            self._chosen = key
            self._show_chosen()
            self._paint()
            self.touch()

    def _show_chosen(self) -> None:
        """Scroll so that the chosen box is in sight."""
        if self._chosen:
            _, rect = self._picture.boxes[self._chosen]
            left, top = rect.x + self._left, rect.y + self._top
            right, bottom = (
                left + rect.width - self.inner_width,
                top + rect.height - self.inner_height + self._switch_rows(),
            )
            self._scroll(max(0, right) + min(0, left), max(0, bottom) + min(0, top))

    def _ask_filter(self, option: str) -> None:
        """Ask for a filter as the fields of the real window take them."""

        def taken(text: str) -> None:
            changed: dict[str, str] = {option: text or "/"}
            self._change(replace(self.graph.options, **changed))  # type: ignore[arg-type]

        texts = self.look.texts
        value = getattr(self.graph.options, option)
        self.ask(texts(f"rqt.{option}"), value, taken, note=texts("rqt.filter_note"))

    def _ask_file(self, *, saving: bool) -> None:
        """Ask where to save the picture (the suffix says as what), or which DOT file to show."""

        def taken(name: str) -> str | None:
            try:
                if saving:
                    self.graph.save(name)
                else:
                    self.graph.load(name)
            except (OSError, ValueError) as error:
                return str((error.strerror if isinstance(error, OSError) else None) or error)
            self.look.wake()
            return None

        texts = self.look.texts
        title, note = ("rqt.save", "rqt.save_note") if saving else ("rqt.load", "rqt.load_note")
        sure = before_replacing(self.look, self.graph.path, taken) if saving else taken
        self.ask(texts(title), "rosgraph.dot", sure, note=texts(note))

    def on_mouse_scroll_down(self, event: events.MouseScrollDown) -> None:
        self._scroll(0, 2)
        event.stop()

    def on_mouse_scroll_up(self, event: events.MouseScrollUp) -> None:
        self._scroll(0, -2)
        event.stop()

    def _change(self, options: Options) -> None:
        self.graph.change_options(options)
        self.pull(self._counted_now)

    def _scroll(self, columns: int, rows: int) -> None:
        x = min(max(0, self._offset[0] + columns), max(0, self._picture.width - self.inner_width))
        y = min(max(0, self._offset[1] + rows), max(0, self._picture.height - self.inner_height + self._switch_rows()))
        if (x, y) != self._offset:
            self._offset = (x, y)
            self.touch()
