"""Draws the lines of the RViz window: the toolbar, the edge of the panel, the view, and the words below it."""

from __future__ import annotations

from functools import partial
from typing import TYPE_CHECKING

from rich.segment import Segment
from rich.style import Style

from day6_tui.panes.cells import cell_len, fit
from day6_tui.windows.rviz.toolbar import names_in

if TYPE_CHECKING:
    from day6_tui.windows.rviz.rviz2 import RVizPane

_FOLDS = {"▸": ("◂", "▴"), "»": ("«", "^"), ">": ("<", "^")}
"""The arrow that opens -> those that fold to the left, and upwards."""


class WindowPainter:
    """Draws from what the window knows, and says what a click on it does; the panel draws itself over the blanks."""

    def __init__(self, pane: RVizPane) -> None:
        self._pane = pane

    def line(self, y: int, width: int) -> list[Segment]:
        """A line of the inside."""
        pane = self._pane
        if y < pane.top:
            return self._toolbar(y, width)
        row = y - pane.top
        panel, edge, view = pane.divided
        if row >= view.bottom:
            return self._words(row - view.bottom, width)
        if panel and row < view.y:
            return self._edge_below(y, width) if row == edge.y else [Segment(" " * width, pane.background)]
        left = [Segment(" " * panel.width, pane.background), self._edge_beside(y, edge.x)] if edge.x < view.x else []
        return [*left, *(self._offer(row - view.y) or pane.view.line(row - view.y))]

    def _hit(self, y: int, column: int, width: int) -> tuple[int, int, int]:
        """Cells of the inside, as the pane counts what can be clicked."""
        offset = self._pane.inner_offset
        return y + offset, column + offset, column + offset + width

    def _toolbar(self, y: int, width: int) -> list[Segment]:
        """The tools: a click chooses one, as its letter does."""
        pane, colours, tools = self._pane, self._pane.look.colours, self._pane.rviz.tools
        segments, end = [], 0
        for name in names_in(tools.tools, tools.current, width):
            segments.append(Segment(" " * (name.column - end), colours.muted))
            chosen = name.tool is tools.current
            key, words = (colours.choice, colours.choice) if chosen else (colours.key, colours.text)
            segments += [Segment(name.letter, key), Segment(f" {name.words}" if name.words else "", words)]
            end = name.end
            pane.add_hit(*self._hit(y, name.column, name.end - name.column), partial(pane.use_tool, name.tool))
        return segments

    def _edge_beside(self, y: int, column: int) -> Segment:
        """The edge between panel and view, with an arrow in its middle that folds and unfolds the panel."""
        pane, glyphs = self._pane, self._pane.look.glyphs
        pane.add_hit(*self._hit(y, column, 1), pane.toggle_panel)
        middle = pane.top + pane.body_height // 2
        if abs(y - middle) <= 1:
            arrow = _FOLDS[glyphs.chevron][0] if pane.panel_open else glyphs.chevron
            return Segment(arrow if y == middle else " ", pane.look.colours.key)
        return Segment(glyphs.border.vertical, self._edge_style)

    def _edge_below(self, y: int, width: int) -> list[Segment]:
        """The edge where there is no room for the panel beside the view, but above it."""
        pane, glyphs = self._pane, self._pane.look.glyphs
        pane.add_hit(*self._hit(y, 0, width), pane.toggle_panel)
        arrow = f" {_FOLDS[glyphs.chevron][1]} "
        left = max(0, (width - len(arrow)) // 2)
        before, after = (glyphs.border.horizontal * each for each in (left, width - left - len(arrow)))
        return [
            Segment(before, self._edge_style),
            Segment(arrow, pane.look.colours.key),
            Segment(after, self._edge_style),
        ]

    @property
    def _edge_style(self) -> Style:
        on_view = self._pane.has_focus and not self._pane.on_panel
        return self._pane.look.colours.frame_focus if on_view else self._pane.look.colours.frame

    def _offer(self, row: int) -> list[Segment]:
        """The lowest line of the view while it offers to look at the robot."""
        pane = self._pane
        if row != pane.view.rows - 1 or not pane.framing.offered:
            return []
        text = fit(f" f  {pane.look.texts('rviz.offer')} ", pane.view.columns, pane.look.glyphs.ellipsis)
        place = pane.view_place
        pane.add_hit(place.y + row, place.x, place.x + cell_len(text), pane.focus_robot)
        return [Segment(text, pane.look.colours.choice)]

    def _words(self, number: int, width: int) -> list[Segment]:
        """A line below the view: what is wrong first, if that is told, then the text."""
        pane, colours = self._pane, self._pane.look.colours
        if pane.problem_told:
            if number == 0:
                pane.add_hit(*self._hit(pane.top + pane.body_height, 0, width), pane.to_problem)
                return [Segment(pane.problems.text(width), colours.warning)]
            number -= 1
        lines = pane.status_bar.lines
        text = lines[number] if number < len(lines) else ""
        return [Segment(fit(f" {text}", width, pane.look.glyphs.ellipsis), colours.muted)]
