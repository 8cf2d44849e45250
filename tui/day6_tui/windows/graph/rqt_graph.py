"""rqt_graph's window: the laid-out graph, its controls as keys, a pulse on every edge along which messages pass."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import replace
from functools import partial
from typing import TYPE_CHECKING

from rich.segment import Segment
from rich.style import Style
from textual import events
from textual.geometry import Region

from day6_core.reason import reason
from day6_core.ros.programs.rqt_graph.model.content import GraphOptions
from day6_core.ros.programs.rqt_graph.model.drawing import (
    ASCII,
    CONSOLE,
    UNICODE,
    CellCanvas,
    Glyphs,
    Highlight,
    Run,
    draw,
    draw_pulse,
)
from day6_core.ros.programs.rqt_graph.model.fit import Forms
from day6_core.ros.programs.rqt_graph.model.rqt_graph import RqtGraph
from day6_core.ros.programs.rqt_graph.model.shapes import LaidOutGraph, Route
from day6_core.session.display import Window
from day6_tui.appearance.look import Look
from day6_tui.overlays.prompt import before_replacing
from day6_tui.panes.cells import cell_len, clip
from day6_tui.panes.pane import Piece
from day6_tui.panes.placement import PaneNeeds
from day6_tui.panes.splits import Extent
from day6_tui.windows import WindowPane
from day6_tui.windows.graph.options import (
    GROUP,
    HIDE,
    NAMESPACES,
    SWITCHES,
    VIEW,
    Switch,
    key_of,
    switched,
    text_of,
)
from day6_tui.windows.graph.view import Viewport
from day6_tui.windows.parts.buttons import Button, button_line, in_lines

if TYPE_CHECKING:
    from day6_tui.pixels.pictures import Pictures
    from day6_tui.windows.graph.pixels import GraphPicture

TALL = 12
"""Lines from which on there is room for the controls below the picture."""

PULSE_SECONDS = 1.2
"""How long a pulse takes along an edge."""

PULSE_REST = 0.6
"""Minimum time between two pulses on one edge: at 62 Hz the eye could not follow them."""

PICTURE_SECONDS = 1 / 15
"""Between two pictures of real pixels."""

LOOK_SECONDS = 0.25
"""How often the message counters are read."""

_GLYPHS: dict[str, Glyphs] = {"half": UNICODE, "braille": UNICODE, "cell": CONSOLE, "ascii": ASCII}

_PANS: dict[str, tuple[int, int]] = {
    "left": (-8, 0),
    "right": (8, 0),
    "up": (0, -2),
    "down": (0, 2),
    "pageup": (0, -10),
    "pagedown": (0, 10),
}

_ZOOMS: dict[str, int] = {"plus": -1, "equals_sign": -1, "minus": 1}


class RqtGraphPane(WindowPane[RqtGraph]):
    """Draws `RqtGraph.content`; keeps only view state: how large, which part of it, and running pulses."""

    needs = PaneNeeds(Extent(38, 8), Extent(60, 14), Extent(100, 24))

    def __init__(self, window: Window[RqtGraph], look: Look) -> None:
        super().__init__(window, look)
        self.graph = window.model
        self._drawn: tuple[object, ...] = ()
        self._picture = LaidOutGraph(0, 0, {}, ())
        self._forms = Forms((), ())
        self._forms_of: tuple[object, ...] = ()
        """What `_forms` was made of."""
        self._form = 0
        self._view = Viewport()
        self._drag: tuple[int, int] | None = None
        """Where the mouse was last while its button is held."""
        self._dragged = False
        self._canvas = CellCanvas(0, 0)
        """What is seen, without the pulses."""
        self._rows: list[list[Run]] = []
        self._counts: dict[str, int] = {}
        self._counted = 0.0
        self._pulses: dict[Route, float] = {}
        self._controls: list[list[Segment | Button]] = []
        self._controls_for: object = None
        self._chosen = ""
        """Key of the box whose edges are highlighted, '' for none."""
        self._fine: GraphPicture | None = None
        """The graph in real pixels, where the terminal shows them."""
        self._shown_at = 0.0

    # -- frame ---------------------------------------------------------------------------------------------------------

    def title(self) -> list[Piece]:
        options = self.graph.options
        text = self.graph.loaded or f"{options.graph_type.value} {self.look.glyphs.chevron}"
        return [*super().title(), Piece(f" {text} ", self.look.colours.muted, lambda: self._switch("t"))]

    def status(self) -> list[Piece]:
        if self.graph.loaded:
            return [Piece(f" {self.look.texts('rqt.loaded', name=self.graph.loaded)} ", self.look.colours.muted)]
        if self._chosen:
            return [Piece(f" {self._about_chosen()} ", self.look.colours.text)]
        count = sum(len(each.names) for each in self.graph.content.hidden)
        if not count:
            return [Piece(f" {self.look.texts('rqt.nothing_hidden')} ", self.look.colours.muted)]
        if not self._switch_rows():
            return [self._told_keys(count)]
        text = self._told_hidden(count, "rqt.hides")
        if cell_len(text) + 2 > self.inner_width:  # not all names can be told: rather how many each box hides
            text = self._told_hidden(count, "rqt.hides_some")
        return [Piece(f" {text} ", self.look.colours.muted)]

    def _told_keys(self, count: int) -> Piece:
        """Where the controls have no room: how much is hidden, and the keys that show it; a click is the first of them."""
        keys = [key for each in self.graph.content.hidden if (key := key_of(each.option))]
        text = self.look.texts("rqt.shown_by", count=count, keys="/".join(keys))
        first = partial(self._switch, keys[0]) if keys and keys[0] in SWITCHES else None
        return Piece(f" {text} ", self.look.colours.muted, first)

    def _told_hidden(self, count: int, each_told: str) -> str:
        texts = self.look.texts
        reasons = texts("rqt.separator").join(
            texts(each_told, option=each.option, names=", ".join(each.names), count=len(each.names))
            for each in self.graph.content.hidden
        )
        return texts("rqt.hidden", count=count, reasons=reasons)

    def key_hints(self) -> list[tuple[str, str]]:
        return [
            ("t", self.look.texts("rqt.type")),
            ("+ -", self.look.texts("rqt.zoom")),
            ("←↑↓→" if self.look.glyphs.unicode else "arrows", self.look.texts("rqt.pan")),
            ("v", self.look.texts("rqt.fit")),
            ("j k", self.look.texts("rqt.choose")),
        ]

    def more_key_hints(self) -> list[tuple[str, str]]:
        return [
            ("d s l p f u", self.look.texts("rqt.hide")),
            ("/ :", self.look.texts("rqt.filter")),
            ("n", self.look.texts("rqt.namespaces")),
            ("1 2 3", self.look.texts("rqt.group")),
            ("h", self.look.texts("rqt.view")),
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
        content, columns, rows = self.graph.content, self.inner_width, self._picture_rows
        made_of = (content, self.look.glyphs.ellipsis)
        if made_of != self._forms_of:
            self._forms_of = made_of
            self._forms = Forms(content.boxes, content.edges, self.look.glyphs.ellipsis)
        if self.graph.options.fit:
            self._form = self._forms.best(columns, rows)
        self._picture = self._forms.picture(self._form, columns, rows)
        self._view.show(self._picture, columns, rows)
        if self.graph.options.fit:
            self._view.centre()
        self._pulses = {}
        if self._chosen not in self._picture.boxes:
            self._chosen = ""
        self._paint()

    @property
    def _picture_rows(self) -> int:
        """Lines for the picture."""
        return max(1, self.inner_height - self._switch_rows())

    def _paint(self) -> None:
        """Draw what is seen."""
        highlight = Highlight(self._chosen, self.graph.content.edges) if self._chosen else None
        if (pictures := self.look.pixels) is not None:
            self._show_pixels(pictures, highlight)
        self._canvas = draw(self._picture, self._glyphs, self.graph.content.trouble, highlight, self._view.part)
        self._paint_over()

    def _paint_over(self) -> None:
        """Draw pulses and hints over a copy of the picture."""
        canvas, glyphs = self._canvas.copy(), self._glyphs
        for route, began in self._pulses.items():
            draw_pulse(canvas, route, (self._counted_now - began) / PULSE_SECONDS, glyphs)
        part = self._view.part
        for x, y, text in self._hints():
            canvas.put(part.x + x, part.y + y, text, "hint")
        self._rows = canvas.rows()

    def _hints(self) -> list[tuple[int, int, str]]:
        """What lies outside of the window, at its edges: column, row and text."""
        part, glyphs, found = self._view.part, self._glyphs, []
        beyond = self._view.beyond(rect for _, rect in self._picture.boxes.values())
        for count, arrow, across, down in (
            (beyond.left, glyphs.left, 0, 1),
            (beyond.right, glyphs.right, 2, 1),
            (beyond.up, glyphs.up, 1, 0),
            (beyond.down, glyphs.down, 1, 2),
        ):
            if count is not None:
                text = f" {arrow} {count} " if count else f" {arrow} "
                found.append(((part.width - len(text)) * across // 2, (part.height - 1) * down // 2, text))
        return found

    @property
    def _glyphs(self) -> Glyphs:
        return _GLYPHS[self.look.glyphs.canvas]

    def _show_pixels(self, pictures: Pictures, highlight: Highlight | None) -> None:
        """Draw in real pixels."""
        from day6_tui.windows.graph.pixels import GraphPicture

        size = self.inner_width, self.inner_height - self._switch_rows()
        if not self.graph.content.boxes or min(size) < 1:
            self._fine = None
            pictures.drop(self)
            return
        cell, fine, trouble = pictures.cell(*size), self._fine, self.graph.content.trouble
        if fine is None or (fine.columns, fine.rows, fine.cell) != (*size, cell):
            fine = self._fine = GraphPicture(*size, cell, self.background, self._style)
            self.touch()
        self._shown_at = self._counted_now
        pulses = {route: (self._counted_now - began) / PULSE_SECONDS for route, began in self._pulses.items()}
        part = self._view.part
        pixels = fine.pixels(self._picture, (-part.x, -part.y), trouble, highlight, pulses)
        hints = [(*hint, self._style("hint")) for hint in self._hints()]
        changed = fine.sheet.put([*fine.texts(self._picture, trouble, highlight), *hints])
        pictures.show(self, Region(self.inner_offset, self.inner_offset, *size), cell, pixels, fine.sheet.holes)
        self.redraw_lines(changed)

    def restyle(self) -> None:
        self._fine, self._drawn = None, ()
        super().restyle()

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
        if self.look.pixels is not None and self._pulses and now - self._shown_at < 0.9 * PICTURE_SECONDS:
            return True
        if self._pulses or moved:
            self._pulses = running
            if (pictures := self.look.pixels) is not None:
                self._show_pixels(pictures, Highlight(self._chosen, self.graph.content.edges) if self._chosen else None)
                return bool(self._pulses)
            self._paint_over()
            self.touch_lines(sorted(line - self._view.y for line in before | self._pulse_lines()))
        return bool(self._pulses)

    def _pulse_lines(self) -> set[int]:
        return {y for route in self._pulses for _, y in route.cells}

    def content_line(self, y: int, width: int) -> Iterable[Segment]:
        below = y - self.inner_height + self._switch_rows()
        if below >= 0:
            return self._switch_line(below, y, width)
        if not self.graph.content.boxes and y == self.inner_height // 2:
            text = clip(f" {self.look.texts('rqt.empty')}", width, self.look.glyphs.ellipsis)
            return [Segment(text, self.look.colours.muted)]
        if self._fine is not None and self.look.pixels is not None:
            return self._fine.sheet.line(y) if y < self._fine.rows else []
        return [Segment(text, self._style(style)) for text, style in self._rows[y]] if y < len(self._rows) else ()

    def _style(self, name: str) -> Style:
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
            "hint": colours.choice,
        }
        return table.get(name, self.background)

    def _switch_rows(self) -> int:
        """Lines for the check boxes: those that hide and, if there is room, those that group."""
        return len(self._switch_lines(self.inner_width)) or bool(self.graph.content.trouble)

    @property
    def _is_tall(self) -> bool:
        return self.inner_height >= TALL

    def _switch_lines(self, width: int) -> list[list[Segment | Button]]:
        """The check boxes as they flow into lines, at most a fifth of the window; none where those that hide need more."""
        texts, most = self.look.texts, max(1, self.inner_height // 5)
        state = (self.graph.options, width, most, self._is_tall, texts.language)
        if state == self._controls_for:
            return self._controls
        lines = self._flowing("rqt.hide", HIDE, width)
        more = self._flowing("rqt.group", (NAMESPACES, *GROUP, *VIEW), width)
        self._controls_for = state
        all_fit = len(lines) + len(more) <= most
        self._controls = [*lines, *more] if all_fit else lines if len(lines) <= most and self._is_tall else []
        return self._controls

    def _flowing(self, head: str, switches: Sequence[Switch], width: int) -> list[list[Segment | Button]]:
        """Controls behind their head, in as many lines as they need."""
        title = self.look.texts("list.head", name=self.look.texts(head))
        buttons = []
        for switch in switches:
            label, on = text_of(switch, self.graph.options)
            buttons.append(Button(switch.key, label, partial(self._switch, switch.key), on))
        size = cell_len(title) + 1
        heads = [f"{title} ", *[" " * size] * len(buttons)]
        lines = in_lines(buttons, width - size - 1)
        return [[Segment(text, self.look.colours.text), *line] for text, line in zip(heads, lines, strict=False)]

    def _switch_line(self, row: int, y: int, width: int) -> list[Segment]:
        """Trouble with QoS or types first, else the check boxes; a click on one is its key."""
        colours = self.look.colours
        trouble = self.graph.content.trouble
        if trouble and row == 0:
            topic = self._chosen if self._chosen in trouble else next(iter(trouble))
            text = f"{self.look.glyphs.warning} {topic.strip()}: {' '.join(trouble[topic])}"
            return [Segment(clip(text, width, self.look.glyphs.ellipsis), colours.warning)]
        return button_line(self, y, self._switch_lines(width)[row], width)

    def _about_chosen(self) -> str:
        """Describe in one line the edges of the chosen box."""
        content = self.graph.content
        box = next(box for box in content.boxes if box.key == self._chosen)
        edges = content.edges
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
        elif key in ("w", "ctrl+s", "o", "ctrl+o"):
            self._ask_file(saving=key in ("w", "ctrl+s"))
        elif key in _PANS:
            self._pan(*_PANS[key])
        elif key in _ZOOMS:
            self._zoom(_ZOOMS[key], self._view.columns // 2, self._view.rows // 2)
        else:
            return
        event.stop()
        event.prevent_default()

    def on_click(self, event: events.Click) -> None:
        """A click on a box chooses it; a click elsewhere chooses none."""
        if self._dragged:
            self._dragged = False
            return
        if self.hit(event.x, event.y) is not None:
            super().on_click(event)
            return
        x, y = event.x - 1 + self._view.x, event.y - 1 + self._view.y
        for box, rect in self._picture.boxes.values():
            if rect.x <= x < rect.x + rect.width and rect.y <= y < rect.y + rect.height:
                self._choose("" if box.key == self._chosen else box.key)
                return
        self._choose("")

    def _switch(self, key: str) -> None:
        self._change(switched(self.graph.options, key))

    def _choose_next(self, step: int) -> None:
        """Choose the next box: column by column, from above."""
        boxes = sorted(self._picture.boxes.values(), key=lambda placed: (placed[1].x, placed[1].y))
        places = list(dict.fromkeys(box.key for box, _ in boxes))
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
        """Pan so that the chosen box is in sight."""
        if self._chosen:
            self._view.reveal(self._picture.boxes[self._chosen][1])

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
                return reason(error)
            self.look.wake()
            return None

        texts = self.look.texts
        title, note = ("rqt.save", "rqt.save_note") if saving else ("rqt.load", "rqt.load_note")
        sure = before_replacing(self.look, self.graph.path, taken) if saving else taken
        self.ask(texts(title), "rosgraph.dot", sure, note=texts(note))

    def _wheel(self, event: events.MouseEvent, notches: int) -> None:
        event.stop()
        self._zoom(notches, event.x - 1, event.y - 1)

    def on_mouse_down(self, event: events.MouseDown) -> None:
        self._dragged = False
        if (
            event.button == 1
            and self.is_inside(event)
            and event.y <= self._view.rows
            and self.hit(event.x, event.y) is None
        ):
            self._drag = (event.x, event.y)
            self.capture_mouse()

    def on_mouse_move(self, event: events.MouseMove) -> None:
        if self._drag is not None and (event.x, event.y) != self._drag:
            before, self._drag = self._drag, (event.x, event.y)
            self._dragged = True
            self._pan(before[0] - event.x, before[1] - event.y)

    def on_mouse_up(self, event: events.MouseUp) -> None:
        if self._drag is not None:
            self._drag = None
            self.release_mouse()

    def _change(self, options: GraphOptions) -> None:
        self.graph.change_options(options)
        self.pull(self._counted_now)

    def _pan(self, columns: int, rows: int) -> None:
        """Move over the picture."""
        self._leave_fit()
        self._view.pan(columns, rows)
        self._redraw()

    def _zoom(self, step: int, column: int, row: int) -> None:
        """Go to a smaller form (1) or a larger one (-1); what is at this cell of the window stays there."""
        columns, rows = self._view.columns, self._view.rows
        form = self._forms.next(self._form, step, columns, rows)
        if form != self._form:
            self._leave_fit()
            self._form, self._pulses = form, {}
            self._picture = self._forms.picture(form, columns, rows)
            self._view.zoom_to(self._picture, column, row)
            self._redraw()

    def _leave_fit(self) -> None:
        """From now on the user decides what is seen."""
        if self.graph.options.fit:
            self._change(replace(self.graph.options, fit=False))

    def _redraw(self) -> None:
        self._paint()
        self.touch()
