"""rqt_plot's window: curves over time with axes that fit themselves, and a legend with the newest values."""

from __future__ import annotations

import math
from collections.abc import Iterable
from typing import TYPE_CHECKING, NamedTuple

from rich.segment import Segment
from rich.style import Style
from textual import events
from textual.geometry import Region

from day6_core.elide import elide
from day6_core.ros.programs.rqt_plot.model.axis import label, limits, seen, ticks
from day6_core.ros.programs.rqt_plot.model.lines import polyline
from day6_core.ros.programs.rqt_plot.model.plot import Curve, Plot
from day6_core.session.display import Window
from day6_core.session.harmless import one_line
from day6_tui.appearance.colours import background_of, foreground_of, pixel_style
from day6_tui.appearance.look import Look
from day6_tui.panes.canvas import Mark, PixelCanvas, new_canvas
from day6_tui.panes.cells import cell_len, clip, fit
from day6_tui.panes.pane import Piece
from day6_tui.windows import WindowPane

if TYPE_CHECKING:
    from day6_tui.pixels.pictures import Pictures

FRAME_SECONDS = 0.1
"""How often the curves are drawn: faster costs more than it shows."""

LABEL_WIDTH = 8
ON_DARK = (0x56B4E9, 0xE69F00, 0x2FC99B, 0xE48BBF, 0xF0E442, 0xFF8A50, 0xA8B8FF, 0xFFFFFF)
ON_LIGHT = (0x0072B2, 0xA65E00, 0x00704F, 0xA8447B, 0x7A6C00, 0xB34700, 0x4A50B8, 0x000000)
"""The palette of Okabe and Ito, brightened and darkened for the two backgrounds."""

SHAPES = "*+ox#@%&"
"""Characters for the curves where there are no pixels."""

MOST_LEGEND = 6

LOW = 12
"""In a window with fewer lines the legend has one, of the chosen curve: the picture needs the others."""

SHORT = 16
"""Cells of the name of a curve that shares the line with the chosen one."""

RANGE_WIDTH = 20
"""Columns for the visible range behind a value."""


class _View(NamedTuple):
    """The visible range: seconds of world time from left to right, values from bottom to top, positions of the ticks."""

    start: float
    end: float
    low: float
    high: float
    step: float


class RqtPlotPane(WindowPane[Plot]):
    """Draws `Plot.curves`; keeps which curve is chosen, and how finely it draws."""

    key_weight = 3  # one more of its keys where there is no room for F8, too

    def __init__(self, window: Window[Plot], look: Look) -> None:
        super().__init__(window, look)
        self.plot = window.model
        self._chosen = 0
        self._canvas: PixelCanvas | None = None
        self._view = _View(0, 1, 0, 1, 1)
        self._spans: dict[str, tuple[float, float]] = {}
        self._state: tuple[object, ...] = ()
        self._drawn_at = -1.0
        self._fine = look.glyphs.canvas in ("half", "braille")

    # -- places --------------------------------------------------------------------------------------------------------

    def _legend_rows(self) -> int:
        most = MOST_LEGEND if self.inner_height >= LOW else 1
        return max(1, min(len(self.plot.curves), most, self.inner_height // 3))

    def _first_in_legend(self) -> int:
        """The index of the curve on the legend's first line: the chosen one is always on it."""
        rows = self._legend_rows()
        return max(0, min(self._chosen - rows + 1, len(self.plot.curves) - rows))

    def _picture(self) -> tuple[int, int]:
        """Columns and rows of the picture between the axes."""
        return max(0, self.inner_width - LABEL_WIDTH - 2), max(0, self.inner_height - self._legend_rows() - 2)

    @property
    def _mode(self) -> str:
        mode = self.look.glyphs.canvas
        return mode if mode in ("cell", "ascii") else "braille" if self._fine else "half"

    # -- frames --------------------------------------------------------------------------------------------------------

    def pull(self, now: float) -> bool:
        columns, rows = self._picture()
        if columns < 4 or rows < 2:
            return False
        if now - self._drawn_at < FRAME_SECONDS and self._state:
            return True
        state = (*self._edges(columns), self.plot.received, self.plot.version, columns, rows, self._mode)
        if state == self._state:
            return self.plot.paused_at is None and bool(self.plot.curves)
        fresh = not self._state
        self._state, self._drawn_at = state, now
        self._draw(columns, rows)
        if fresh:
            super().touch()
        else:
            self.touch_lines(range(self.inner_height))
            self.touch_frame()
        return self.plot.paused_at is None and bool(self.plot.curves)

    def _edges(self, columns: int) -> tuple[float, float]:
        """The times at the left and right edge; they move by whole cells, so that characters wander without changing."""
        pictures = self.look.pixels
        cell = self.plot.span / (columns * pictures.cell(*self._picture())[0] if pictures is not None else columns)
        end = math.ceil(self.plot.now() / cell) * cell
        return end - self.plot.span, end

    def _draw(self, columns: int, rows: int) -> None:
        background = background_of(self.background)
        canvas = self._canvas
        if canvas is None or (canvas.columns, canvas.rows, canvas.mode) != (columns, rows, self._mode):
            canvas = self._canvas = new_canvas(columns, rows, self._mode, background, self.look.colours)
        start, end = self._edges(columns)
        pieces = []
        self._spans = {}
        for curve in self.plot.curves:
            times, values = curve.points
            first, last = seen(times, values, start, end)
            if first < last:
                pieces.append((curve, times[first:last], values[first:last]))
                self._spans[curve.path] = (min(values[first:last]), max(values[first:last]))
        self._view = self._fitted(start, end, rows)
        if self.look.pixels is not None:
            self._show_pixels(self.look.pixels, columns, rows, pieces)
            return
        sprites: dict[int, int] = {}
        marks: dict[tuple[int, int], Mark] = {}
        for curve, times, values in pieces:
            colour = self._colour(curve)
            for x, y in self._pixels(times, values, canvas):
                if canvas.mode in ("cell", "ascii"):
                    marks[x, y] = Mark(SHAPES[curve.number % len(SHAPES)], colour)
                else:
                    sprites[y * canvas.width + x] = colour
        canvas.set_sprites(sprites)
        canvas.set_marks(marks)

    def _show_pixels(
        self, pictures: Pictures, columns: int, rows: int, pieces: list[tuple[Curve, list[float], list[float]]]
    ) -> None:
        """Draw in real pixels."""
        from day6_tui.windows.rqt.plot_pixels import paint_plot

        view, colours = self._view, self.look.colours
        if not self.plot.curves:
            pictures.drop(self)
            return
        cell = pictures.cell(columns, rows)
        width, height = columns * cell[0], rows * cell[1]
        across, down = (width - 1) / (view.end - view.start), (height - 1) / (view.high - view.low)
        curves = [
            (
                self._colour(curve),
                [((x - view.start) * across, (view.high - y) * down) for x, y in zip(times, values, strict=True)],
            )
            for curve, times, values in pieces
        ]
        middle = cell[0] / 2
        grid = foreground_of(colours.frame), [(column * cell[0]) + middle for column in self._time_ticks(columns)]
        levels = [(view.high - value) * down for value in self._levels()]
        pixels = paint_plot((width, height), background_of(self.background), (*grid, levels), curves)
        place = Region(self.inner_offset + LABEL_WIDTH + 2, self.inner_offset, columns, rows)
        pictures.show(self, place, cell, pixels)

    def _levels(self) -> list[float]:
        """The values of the ticks."""
        view = self._view
        return [view.low + number * view.step for number in range(round((view.high - view.low) / view.step) + 1)]

    def _fitted(self, start: float, end: float, rows: int) -> _View:
        """The limits for the visible values, at round numbers, so that they rarely change."""
        lowest = min((low for low, _ in self._spans.values()), default=0.0)
        highest = max((high for _, high in self._spans.values()), default=1.0)
        low, high, step = limits(lowest, highest, max(3, rows // 3))
        return _View(start, end, low, high, step)

    def _pixels(self, times: list[float], values: list[float], canvas: PixelCanvas) -> set[tuple[int, int]]:
        view = self._view
        across = (canvas.width - 1) / (view.end - view.start)
        down = (canvas.height - 1) / (view.high - view.low)
        points = [
            (round((time - view.start) * across), round((view.high - value) * down))
            for time, value in zip(times, values, strict=True)
        ]
        return polyline(points, canvas.width, canvas.height)

    def _colour(self, curve: Curve) -> int:
        palette = ON_DARK if self.look.colours.dark else ON_LIGHT
        return palette[curve.number % len(palette)]

    def _curve_style(self, curve: Curve) -> Style:
        if self.look.colours.colourless:
            return self.look.colours.text
        return pixel_style(self._colour(curve), background_of(self.background))

    def on_resize(self, event: events.Resize) -> None:
        super().on_resize(event)
        self._forget()

    def restyle(self) -> None:
        self._forget()
        super().restyle()

    def _forget(self) -> None:
        self._canvas = None
        self._state = ()

    # -- lines ---------------------------------------------------------------------------------------------------------

    def content_line(self, y: int, width: int) -> Iterable[Segment]:
        columns, rows = self._picture()
        if columns < 4 or rows < 2:
            return ()
        if self._canvas is None or (self._canvas.columns, self._canvas.rows) != (columns, rows):
            self._draw(columns, rows)
        if y < rows:
            return self._picture_line(y, columns, rows)
        if y == rows:
            return self._axis_line(columns)
        if y == rows + 1:
            return self._time_line(columns)
        return self._legend_line(y - rows - 2, width)

    def _picture_line(self, row: int, columns: int, rows: int) -> list[Segment]:
        colours, canvas, view = self.look.colours, self._canvas, self._view
        assert canvas is not None
        down = (rows * canvas.down - 1) / (view.high - view.low)
        here = [value for value in self._levels() if round((view.high - value) * down) // canvas.down == row]
        text = label(here[0], view.step) if here else ""
        edge = ("┤" if here else self.look.glyphs.border.vertical) if self.look.glyphs.unicode else "+" if here else "|"
        axis = [
            Segment(clip(text, LABEL_WIDTH, "").rjust(LABEL_WIDTH) + " ", colours.muted),
            Segment(edge, colours.frame),
        ]
        if not self.plot.curves and row == rows // 2:
            hint = clip(self.look.texts("plot.none"), columns, self.look.glyphs.ellipsis)
            return [*axis, Segment(hint, colours.muted)]
        if self.look.pixels is not None:
            return [*axis, Segment(" " * columns, self.background)]
        return [*axis, *canvas.line(row)]

    def _time_ticks(self, columns: int) -> dict[int, str]:
        """Labels by column: seconds before the right edge."""
        span = self.plot.span
        most = max(2, min(6, columns // 12))
        places = ticks(0.0, span, most)
        step = places[1] - places[0] if len(places) > 1 else span
        return {
            columns - 1 - round(place / span * (columns - 1)): label(-place, step) + (" s" if not place else "")
            for place in places
        }

    def _axis_line(self, columns: int) -> list[Segment]:
        border = self.look.glyphs.border
        marks = self._time_ticks(columns)
        tick = "┬" if self.look.glyphs.unicode else "+"
        line = "".join(tick if column in marks else border.horizontal for column in range(columns))
        return [Segment(" " * (LABEL_WIDTH + 1) + border.bottom_left + line, self.look.colours.frame)]

    def _time_line(self, columns: int) -> list[Segment]:
        left = LABEL_WIDTH + 2
        cells = [" "] * (left + columns)
        for column, text in self._time_ticks(columns).items():
            first = max(0, min(left + columns - len(text), left + column - len(text) // 2))
            cells[first : first + len(text)] = text
        return [Segment("".join(cells), self.look.colours.muted)]

    def _legend_line(self, line: int, width: int) -> list[Segment]:
        curves = self.plot.curves
        if not curves:
            message = clip(self.plot.message, width - 1, self.look.glyphs.ellipsis)
            return [Segment(" " + message, self.look.colours.warning)] if message else []
        first = self._first_in_legend()
        if first + line >= len(curves):
            return []
        curve = curves[first + line]
        colours, glyphs = self.look.colours, self.look.glyphs
        on = first + line == self._chosen
        alone = self._legend_rows() == 1 and len(curves) > 1
        longest = cell_len(curve.path) if alone else max(cell_len(each.path) for each in curves)
        ranged = width >= 56 and not alone
        name_width = max(8, min(longest, width - 18 - (RANGE_WIDTH if ranged else 0)))
        text, style = self._value_of(curve, ranged)
        segments = [
            Segment(f"{glyphs.marker if on else ' '} ", colours.accent),
            Segment(self._swatch(curve), self._curve_style(curve)),
            Segment(
                " " + fit(elide(one_line(curve.path), name_width, glyphs.ellipsis), name_width),
                colours.choice if on and self.has_focus else colours.topic,
            ),
            Segment(" " + clip(text, max(0, width - name_width - 7), glyphs.ellipsis), style),
        ]
        return segments + (self._others(first, width - sum(cell_len(each.text) for each in segments)) if alone else [])

    def _swatch(self, curve: Curve) -> str:
        glyphs = self.look.glyphs
        return "━━" if glyphs.unicode and glyphs.canvas != "cell" else SHAPES[curve.number % len(SHAPES)] * 2

    def _others(self, chosen: int, room: int) -> list[Segment]:
        """Whose the other curves are, as many as have room beside the chosen one."""
        segments: list[Segment] = []
        for curve in (*self.plot.curves[chosen + 1 :], *self.plot.curves[:chosen]):
            name = elide(one_line(curve.path), SHORT, self.look.glyphs.ellipsis)
            room -= cell_len(name) + 6
            if room < 0:
                break
            segments += [
                Segment("   ", self.look.colours.text),
                Segment(self._swatch(curve), self._curve_style(curve)),
                Segment(f" {name}", self.look.colours.topic),
            ]
        return segments

    def _value_of(self, curve: Curve, ranged: bool) -> tuple[str, Style]:
        """The text after a curve's name: its newest value, its visible range if there is room, or why there is none."""
        colours, texts = self.look.colours, self.look.texts
        if curve.problem:
            return curve.problem, colours.warning
        if curve.last is None:
            return texts("plot.quiet" if curve.topic else "plot.waiting"), colours.muted
        text = f"{curve.last:>11.5g}"
        if ranged and curve.path in self._spans:
            low, high = self._spans[curve.path]
            text += f"   {low:.4g} {'…' if self.look.glyphs.unicode else '..'} {high:.4g}"
        return text, colours.strong

    def status(self) -> list[Piece]:
        texts, colours = self.look.texts, self.look.colours
        pieces = [Piece(f" {texts('plot.seconds', count=f'{self.plot.span:g}')} ", colours.muted)]
        if (count := len(self.plot.curves)) > self._legend_rows():
            pieces.append(Piece(f" {self._chosen + 1}/{count} ", colours.muted))
        if self.plot.paused_at is not None:
            pieces.append(Piece(f" {self.look.glyphs.paused} {texts('plot.paused')} ", colours.hint))
        if self.plot.message and self.plot.curves:
            pieces.append(Piece(f" {self.look.glyphs.warning} {self.plot.message} ", colours.warning))
        return pieces

    # -- keys ----------------------------------------------------------------------------------------------------------

    def key_hints(self) -> list[tuple[str, str]]:
        texts = self.look.texts
        hints = [("a", texts("plot.add")), ("e", texts("plot.type"))]
        if self.plot.curves:
            hints += [
                ("Del", texts("plot.remove")),
                ("Space", texts("plot.resume" if self.plot.paused_at is not None else "plot.pause")),
                ("+ -", texts("plot.span")),
                ("c", texts("plot.clear")),
            ]
        return hints

    def more_key_hints(self) -> list[tuple[str, str]]:
        texts = self.look.texts
        arrows = "↑ ↓" if self.look.glyphs.unicode else "up down"
        fine = [("g", texts("plot.fine"))] if self.look.glyphs.canvas in ("half", "braille") else []
        return [(arrows, texts("plot.curve")), *fine]

    def _press(self, key: str, character: str) -> bool:
        if key in ("up", "down"):
            self._chosen = max(0, min(len(self.plot.curves) - 1, self._chosen + (1 if key == "down" else -1)))
            self.touch()
        elif key in ("plus", "equals_sign", "minus"):
            self.plot.zoom(1 if key == "minus" else -1)
        elif key in ("p", "space"):
            self.plot.toggle_paused()
        elif key == "c":
            self.plot.clear()
        elif key == "a":
            self._choose_field()
        elif key == "e":
            self._type_field()
        elif key in ("delete", "backspace", "d"):
            self._remove()
        elif key == "g":
            self._fine = not self._fine
            self._forget()
        else:
            return False
        return True

    def _choose_field(self) -> None:
        from day6_tui.overlays.menu import Menu, MenuEntry

        plotted = {curve.path for curve in self.plot.curves}
        entries = [
            MenuEntry(path, "", lambda path=path: self.plot.add(path))  # type: ignore[misc]
            for path in self.plot.suggestions()
            if path not in plotted
        ]
        if entries:
            self.lay_over(Menu(self.look, "plot.choose", entries))
        else:
            self._type_field()

    def _type_field(self) -> None:
        def taken(text: str) -> None:
            if text.strip():
                self.plot.add(text)

        self.ask(self.look.texts("plot.choose"), "", taken, note=self.look.texts("plot.type.note"))

    def _remove(self) -> None:
        if self.plot.curves:
            self.plot.remove(self.plot.curves[min(self._chosen, len(self.plot.curves) - 1)])
            self._chosen = max(0, min(self._chosen, len(self.plot.curves) - 2))

    def on_click(self, event: events.Click) -> None:
        super().on_click(event)
        line = event.y - self.inner_offset - self._picture()[1] - 2
        first = self._first_in_legend()
        if 0 <= line < self._legend_rows() and first + line < len(self.plot.curves):
            self._chosen = first + line
            self.touch()

    def _wheel(self, event: events.MouseEvent, notches: int) -> None:
        event.stop()
        self.plot.zoom(notches)
        self.look.wake()
