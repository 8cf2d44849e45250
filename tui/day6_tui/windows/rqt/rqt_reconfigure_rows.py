"""The lines of opened nodes in Parameter Reconfigure: a head for each node, below it a line for each parameter."""

from __future__ import annotations

import math
from collections.abc import Mapping
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

from rich.segment import Segment
from rich.style import Style

from day6_core.elide import elide
from day6_core.ros.programs.rqt_reconfigure.values import shown
from day6_core.session.harmless import one_line
from day6_tui.panes.cells import cell_len, clip, fit

if TYPE_CHECKING:
    from day6_core.ros.programs.rqt_reconfigure.opened import OpenNode, Parameter
    from day6_tui.appearance.look import Look

VALUE_WIDTH = 9
"""Cells of the number beside a slider."""

LIMIT_WIDTH = 7
"""Cells of each end of a slider, where there is room for both."""

Key = tuple[str, str]
"""What a line is about: the full name of a node, and that of a parameter ('' for the node itself)."""


@dataclass(frozen=True, slots=True)
class ParameterRow:
    """One line. `key` is None for a remark, which cannot be chosen."""

    node: OpenNode
    parameter: Parameter | None = None
    remark: str = ""
    warns: bool = False

    @property
    def is_changeable(self) -> bool:
        """Whether it is a parameter to which another value can be given now."""
        return self.node.there and self.parameter is not None and not self.parameter.read_only

    @property
    def key(self) -> Key | None:
        if self.remark:
            return None
        return self.node.name, self.parameter.name if self.parameter is not None else ""


def rows_of(opened: tuple[OpenNode, ...], text: str, look: Look) -> list[ParameterRow]:
    """The lines of all opened nodes; of the parameters only those with `text` in their names, in any case."""
    rows = []
    for node in opened:
        rows.append(ParameterRow(node))
        remark, warns = _state(node, look)
        if remark:
            rows.append(ParameterRow(node, remark=remark, warns=warns))
        for parameter in node.parameters:
            if text.casefold() in parameter.name.casefold():
                rows.append(ParameterRow(node, parameter))
                if parameter.refusal:
                    rows.append(ParameterRow(node, parameter, parameter.refusal, True))
    return rows


def _state(node: OpenNode, look: Look) -> tuple[str, bool]:
    """What is to be said of a node as a whole, and whether it is a warning."""
    texts = look.texts
    if not node.there:
        return texts("reconfigure.gone" if node.parameters else "reconfigure.not_there"), True
    if node.waited is not None and node.waited >= 1:
        return texts("reconfigure.waiting", seconds=node.waited, reason=node.message), True
    if node.message:
        return node.message, True
    if not node.complete:
        return texts("reconfigure.unread" if node.waited is None else "reconfigure.reading"), False
    return ("" if node.parameters else texts("reconfigure.no_parameters")), False


def number_text(value: float, width: int) -> str:
    """A number in at most `width` cells, with as many digits as there is room for."""
    text = str(value)
    digits = width
    while len(text) > width and digits > 1:
        digits -= 1
        text = f"{value:.{digits}g}"
    return text


class Editors:
    """Draws the lines of parameters, all equally divided; `tracks` are the sliders drawn since `begin`: first column, cells."""

    def __init__(self, look: Look) -> None:
        self.look = look
        self.tracks: dict[Key, tuple[int, int]] = {}
        self._name = self._room = 0
        self._limits = False

    def begin(self, rows: list[ParameterRow], width: int) -> None:
        """Divide `width` cells for the lines that are in sight."""
        self.tracks = {}
        longest = max((cell_len(row.parameter.name) for row in rows if row.parameter is not None), default=0)
        self._name = min(longest, max(8, width * 2 // 5))
        self._room = max(0, width - self._name - 5)
        self._limits = self._room >= VALUE_WIDTH + 2 * LIMIT_WIDTH + 12

    def cuts(self, parameter: Parameter) -> bool:
        """Whether there is no room for the whole name of a parameter."""
        return cell_len(parameter.name) > self._name

    def cuts_value(self, parameter: Parameter) -> bool:
        """Whether there is no room for the whole text of a value."""
        value = parameter.value
        return not isinstance(value, (bool, int, float)) and cell_len(shown(value)) > self._room

    @property
    def value_column(self) -> int:
        """The column from which a line shows the value."""
        return self._name + 4

    def line(
        self, row: ParameterRow, chosen: bool, focused: bool, dragged: Mapping[Key, Any], width: int
    ) -> list[Segment]:
        """The segments of one line; of a parameter that the mouse drags with the value it would get."""
        colours, glyphs = self.look.colours, self.look.glyphs
        mark = Segment(f" {glyphs.marker if chosen else ' '}", colours.accent)
        on = colours.choice if chosen and focused else None
        if row.remark:
            sign = f"{glyphs.warning} " if row.warns else ""
            style = colours.warning if row.warns else colours.muted
            return [Segment("   " + clip(sign + row.remark, width - 3, glyphs.ellipsis), style)]
        there = row.node.there
        if row.parameter is None:
            style = on or (colours.node + Style(bold=True) if there else colours.muted)
            return [
                mark,
                Segment(fit(row.node.name, width - 5, glyphs.ellipsis), style),
                Segment(f" {glyphs.close} ", colours.muted),
            ]
        # Of long names the end tells them apart.
        name = fit(elide(one_line(row.parameter.name), self._name, glyphs.ellipsis), self._name)
        style = on or (colours.strong if chosen else colours.topic) if there else on or colours.muted
        return [mark, Segment(" " + name, style), Segment(" ", colours.text), *self._editor(row, dragged)]

    def _editor(self, row: ParameterRow, dragged: Mapping[Key, Any]) -> list[Segment]:
        parameter, colours, glyphs = row.parameter, self.look.colours, self.look.glyphs
        assert parameter is not None and row.key is not None
        value = dragged.get(row.key, parameter.value)
        style = colours.muted if not row.node.there or parameter.read_only else colours.strong
        if parameter.sent or row.key in dragged:
            style = colours.hint if parameter.sent else colours.accent
        if isinstance(value, bool):
            return [Segment("[x]" if value else "[ ]", style), *self._read_only(parameter, 3)]
        if parameter.range is not None and not parameter.read_only and self._room >= VALUE_WIDTH + 6:
            return self._slider(row, value, style)
        text = number_text(value, self._room) if isinstance(value, float) else shown(value)
        remark = self._read_only(parameter, 0)
        room = self._room - sum(cell_len(each.text) for each in remark)
        text = clip(text, room, glyphs.ellipsis)
        return [Segment(text, style), *(self._read_only(parameter, 0) if text else [])]

    def _read_only(self, parameter: Parameter, used: int) -> list[Segment]:
        text = f"  {self.look.texts('reconfigure.read_only')}"
        fits = parameter.read_only and cell_len(text) + used <= self._room // 2
        return [Segment(text, self.look.colours.muted)] if fits else []

    def _slider(self, row: ParameterRow, value: float, style: Style) -> list[Segment]:
        parameter, colours, unicode = row.parameter, self.look.colours, self.look.glyphs.unicode
        assert parameter is not None and parameter.range is not None and row.key is not None
        width, column = self._room - VALUE_WIDTH - 1, self.value_column
        ends = [Segment("", colours.muted)] * 2
        if self._limits:
            low, high = (number_text(each, LIMIT_WIDTH) for each in (parameter.range.minimum, parameter.range.maximum))
            ends = [Segment(f"{low:>{LIMIT_WIDTH}} ", colours.muted), Segment(f" {high:<{LIMIT_WIDTH}}", colours.muted)]
            width -= 2 * (LIMIT_WIDTH + 1)
            column += LIMIT_WIDTH + 1
        self.tracks[row.key] = (column, width)
        knob = round(parameter.range.place(value) * (width - 1)) if not math.isnan(value) else -1
        bar, dot = ("─", "■" if self.look.glyphs.canvas == "cell" else "●") if unicode else ("-", "O")
        track = [
            Segment(bar * max(0, knob), colours.muted),
            Segment(dot if knob >= 0 else bar, colours.publisher if row.node.there else colours.muted),
            Segment(bar * (width - 1 - max(0, knob)), colours.muted),
        ]
        number = number_text(value, VALUE_WIDTH)
        return [ends[0], *track, ends[1], Segment(f" {number:>{VALUE_WIDTH}}", style)]
