"""The car from above in real pixels; what is written beside it stays text."""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from itertools import combinations

from rich.style import Style

from day6_tui.appearance.colours import Colours, background_of
from day6_tui.panes.cells import cell_len
from day6_tui.pixels.bands import Array
from day6_tui.pixels.raster import Surface
from day6_tui.pixels.sheet import Sheet, Text
from day6_tui.windows.robot.robot_pixels import paint_robot
from day6_tui.windows.world.picture import CASTER, NOSE, look_of
from day6_urdf.kinematics import Transform
from day6_urdf.model import Robot
from day6_urdf.topplan import TopPlan, plan_top, stand

ARROW_CELLS = 6
"""Columns in front of the car, for the arrow."""


class CarPicture:
    """`columns` x `rows` cells of `cell` pixels. The car faces right, to scale."""

    def __init__(self, columns: int, rows: int, cell: tuple[int, int], colours: Colours) -> None:
        self.columns, self.rows, self.cell = columns, rows, cell
        self.sheet = Sheet(columns, rows, colours.text)
        self._colours = colours
        self._table = look_of(colours)
        self._plan: TopPlan | None = None
        self._scale = 1.0
        self._zero = self._middle = (0.0, 0.0)

    def pixels(self, robot: Robot, transforms: Mapping[str, Transform], zoom: float, shift: tuple[int, int]) -> Array:
        """The picture of these transforms; `zoom` and `shift` (columns, rows) as `topview.render_top` has them."""
        if self._plan is None or self._plan.robot is not robot:
            self._plan = plan_top(robot)
        plan = self._plan
        width, height = self.columns * self.cell[0], self.rows * self.cell[1]
        left, bottom, right, top = plan.bounds
        across, down = width - (ARROW_CELLS + 1) * self.cell[0], height - 4 * self.cell[1]
        self._scale = zoom * min(max(across, 1) / max(right - left, 1e-6), max(down, 1) / max(top - bottom, 1e-6))
        self._middle = (left + right) / 2, (bottom + top) / 2
        self._zero = (
            (width - ARROW_CELLS * self.cell[0]) / 2 + shift[0] * self.cell[0],
            height / 2 - self.cell[1] / 2 + shift[1] * self.cell[1],
        )
        surface = Surface(width, height, max(0, background_of(self._colours.text)))
        paint_robot(surface, plan, transforms, self._place, self._scale, self._table)
        for start, end, _ in self._axles(transforms):
            surface.line([self._place(start), self._place(end)], self._table[CASTER], 1.0)
        x, y = self._place((right, 0.0))
        tip, thick = x + (ARROW_CELLS - 1.5) * self.cell[0], self.cell[1] / 3
        colour = self._table[NOSE] if self._colours.dark else 0x2F55D4
        surface.line([(x + self.cell[0], y), (tip - thick, y)], colour, 2.0)
        surface.polygon([(tip - 1.6 * thick, y - thick), (tip, y), (tip - 1.6 * thick, y + thick)], colour)
        return surface.pixels()

    def texts(self, transforms: Mapping[str, Transform], labels: Mapping[str, str]) -> list[Text]:
        """Readings beside the wheels, lengths of axles, a scale; for the picture that was drawn last."""
        if self._plan is None:
            return []
        at, colours = {**self._plan.rest, **transforms}, self._colours
        found: list[Text] = []
        for wheel in self._plan.wheels:
            (x, y), (hx, hy) = stand(wheel, at)
            link = wheel.joint.child
            reach = abs(hy) * wheel.radius + abs(hx) * wheel.width / 2
            above = y >= self._middle[1]
            column, row = self._cell_of((x, y + reach if above else y - reach))
            text, style = labels.get(link, link), colours.text if link in transforms else colours.warning
            first = max(0, min(self.columns - cell_len(text), column - cell_len(text) // 2))
            found.append((first, row - 1 if above else row + 1, text, style))
        for start, end, length in self._axles(transforms):
            column, row = self._cell_of(((start[0] + end[0]) / 2, (start[1] + end[1]) / 2))
            found.append((column + 1, row, f" {length:.2f} m ", colours.muted))
        return [*found, self._scale_text(colours.muted)]

    def _scale_text(self, style: Style) -> Text:
        """A bar of a round length in the last row."""
        column = self.cell[0] / self._scale
        wanted = column * self.columns / 5
        power = 10.0 ** math.floor(math.log10(wanted))
        length = max(step * power for step in (1, 2, 5) if step * power <= wanted)
        cells = round(length / column)
        return 1, self.rows - 1, f"├{'─' * max(0, cells - 1)}┤ {length:g} m", style

    def _axles(
        self, transforms: Mapping[str, Transform]
    ) -> Sequence[tuple[tuple[float, float], tuple[float, float], float]]:
        """Pairs of wheels that share an axis: their centres in metres, and the distance."""
        if self._plan is None:
            return ()
        at = {**self._plan.rest, **transforms}
        found = []
        for one, two in combinations(self._plan.wheels, 2):
            ((x, y), heading), ((ox, oy), other) = stand(one, at), stand(two, at)
            along, across = (ox - x) * heading[0] + (oy - y) * heading[1], math.hypot(ox - x, oy - y)
            alike = abs(heading[0] * other[0] + heading[1] * other[1]) > 0.98
            if one.joint.parent == two.joint.parent and alike and abs(along) < 0.05 * across:
                found.append(((x, y), (ox, oy), across))
        return found

    def _place(self, spot: tuple[float, float]) -> tuple[float, float]:
        x, y = spot
        return (
            self._zero[0] + (x - self._middle[0]) * self._scale,
            self._zero[1] - (y - self._middle[1]) * self._scale,
        )

    def _cell_of(self, spot: tuple[float, float]) -> tuple[int, int]:
        x, y = self._place(spot)
        return int(x // self.cell[0]), int(y // self.cell[1])
