"""The robot from above as text: chassis, wheels with treads that move as the wheel turns, caster, heading, axle, scale.

Pure drawing. The robot faces right (x right, y up, as on paper and in RViz's TopDownOrtho), to scale, with cells twice as high
as wide. `render_top` draws the given transforms of the links in the root link's frame and nothing else: a wheel turns because
its transform does. A link without a transform is drawn at its rest pose, in the style "missing".
"""

from __future__ import annotations

import math
from collections.abc import Mapping

from day6_urdf.canvas import Canvas, Row, cell_width
from day6_urdf.kinematics import Transform
from day6_urdf.model import Robot
from day6_urdf.topplan import Body, TopPlan, Wheel, flat, hull, plan_top, spin_of, stand

STYLES = ("", "chassis", "body", "wheel", "mark", "caster", "arrow", "axle", "label", "missing", "scale")
"""The styles of a run; the empty one is background."""

_LINES = {"ascii": "++++-|"}
_BOX_LINES = "┌┐└┘─│"
_MARGIN_RIGHT = 5  # cells in front for the heading arrow
_STRAIGHT = 0.98  # cosine of the steering angle above which a wheel is drawn as straight
_LABEL_ROWS = 13  # rows needed for labels above and below


_kept: TopPlan | None = None


def render_top(
    robot: Robot,
    transforms: Mapping[str, Transform],
    columns: int,
    rows: int,
    glyphs: str = "ascii",
    labels: Mapping[str, str] | None = None,
    zoom: float = 1.0,
    shift: tuple[int, int] = (0, 0),
) -> list[Row]:
    """Return `rows` rows of (text, style) runs, each exactly `columns` cells wide.

    `transforms` are those of the links in the root link's frame. `labels` are short texts by link name, shown next to the
    wheels where there is room (by default the link names). `glyphs` 'ascii' draws with ASCII only, others with box lines.
    `zoom` enlarges the picture about its centre; at 1 the whole robot fits. `shift` moves it by columns and rows.
    """
    global _kept
    plan = _kept
    if plan is None or plan.robot is not robot:
        plan = _kept = plan_top(robot)
    canvas = Canvas(columns, rows)
    if columns > 0 and rows > 0:
        _Drawing(plan, transforms, canvas, _LINES.get(glyphs, _BOX_LINES), labels or {}, zoom, shift).draw()
    return canvas.rows()


class _Drawing:
    """One picture: computes the scale that fits the canvas, then draws the parts from the ground up."""

    def __init__(
        self,
        plan: TopPlan,
        transforms: Mapping[str, Transform],
        canvas: Canvas,
        lines: str,
        labels: Mapping[str, str],
        zoom: float,
        shift: tuple[int, int],
    ) -> None:
        self._plan = plan
        self._given = transforms
        self._at = {**plan.rest, **transforms}
        self._canvas = canvas
        self._lines = lines
        self._labels = labels
        left, bottom, right, top = plan.bounds
        self._label_rows = 1 if canvas.height >= _LABEL_ROWS else 0
        self._scale_rows = 1 if canvas.height >= 6 else 0
        height = max(canvas.height - self._scale_rows - 2 * self._label_rows, 1)
        width = max(canvas.width - _MARGIN_RIGHT - 1, 1)
        # Half a cell is left free at every side, because a line at the very edge is rounded to the nearest cell.
        per_row = max((top - bottom) / max(height - 0.1, 0.9), 1e-6)
        per_column = max((right - left) / max(width - 0.1, 0.9), 1e-6)
        self._column = max(per_column, per_row / 2) / max(zoom, 0.01)
        self._row = 2 * self._column
        self._middle = ((left + right) / 2, (bottom + top) / 2)
        self._zero = (
            (canvas.width - _MARGIN_RIGHT) / 2 - 0.5 + shift[0],
            self._label_rows + height / 2 - 0.5 + shift[1],
        )

    def draw(self) -> None:
        for body in sorted(self._plan.bodies, key=lambda body: body.style != "chassis"):
            self._draw_body(body)
        self._draw_axles()
        for wheel in self._plan.wheels:
            self._draw_wheel(wheel)
        self._draw_heading()
        if self._label_rows:
            self._draw_name()
            self._draw_labels()
        else:
            self._draw_readings()
        if self._scale_rows:
            self._draw_scale()

    def _x(self, x: float) -> float:
        return self._zero[0] + (x - self._middle[0]) / self._column

    def _y(self, y: float) -> float:
        return self._zero[1] - (y - self._middle[1]) / self._row

    def _cell(self, x: float, y: float) -> tuple[int, int]:
        return _nearest(self._x(x)), _nearest(self._y(y))

    def _style(self, link: str, style: str) -> str:
        return style if link in self._given or link == self._plan.robot.root else "missing"

    def _draw_body(self, body: Body) -> None:
        transform = self._at[body.link]
        style = self._style(body.link, body.style)
        points = [flat(transform, point) for point in body.points]
        if len(points) == 1:
            if body.radius > 0:
                self._draw_circle(*points[0], body.radius, style)
            else:
                self._canvas.put(*self._cell(*points[0]), "x", style)
            return
        outline = [self._cell(*point) for point in hull(points)]
        xs, ys = [x for x, _ in outline], [y for _, y in outline]
        corners = {(x, y) for x in (min(xs), max(xs)) for y in (min(ys), max(ys))}
        if set(outline) <= corners:
            self._canvas.box(min(xs), min(ys), max(xs), max(ys), self._lines, style)
        else:
            for start, end in zip(outline, outline[1:] + outline[:1], strict=True):
                self._canvas.line(*start, *end, self._lines, style)

    def _draw_circle(self, x: float, y: float, radius: float, style: str) -> None:
        column, row = self._cell(x, y)
        reach = int(radius / self._row)
        wide = radius / self._column
        for step in range(-reach, reach + 1):
            share = math.sqrt(max(1 - (step * self._row / radius) ** 2, 0.0)) if reach else 1.0
            half = max(int(wide * share + 0.5), 1 if wide > 0.4 else 0)
            if reach and abs(step) == reach:
                edge = "." if step < 0 else "'"
                text = edge + "-" * (2 * half - 1) + edge if half else edge
                self._canvas.text(column - half, row + step, text, style)
            elif half:
                self._canvas.put(column - half, row + step, "(", style)
                self._canvas.put(column + half, row + step, ")", style)
            else:
                self._canvas.put(column, row, "o", style)

    def _draw_axles(self) -> None:
        """Draw a line between two wheels that share an axis, with its length."""
        stands = [(wheel, *stand(wheel, self._at)) for wheel in self._plan.wheels]
        for index, (wheel, (x, y), heading) in enumerate(stands):
            for other, (ox, oy), other_heading in stands[index + 1 :]:
                along = (ox - x) * heading[0] + (oy - y) * heading[1]
                across = math.hypot(ox - x, oy - y)
                alike = abs(heading[0] * other_heading[0] + heading[1] * other_heading[1]) > 0.98
                if wheel.joint.parent == other.joint.parent and alike and abs(along) < 0.05 * across:
                    self._draw_axle((x, y), (ox, oy), across)

    def _draw_axle(self, start: tuple[float, float], end: tuple[float, float], length: float) -> None:
        (x, y), (ox, oy) = sorted((self._cell(*start), self._cell(*end)), key=lambda cell: cell[1])
        if x != ox or oy - y < 3:
            return
        for row in range(y + 1, oy):
            self._canvas.put(x, row, ":", "axle")
        text = f" {length:.2f} m"
        middle = (y + oy) // 2
        # Next to the middle of the line, or as close to it as there is room.
        rows = sorted(range(y + 2, oy - 1), key=lambda row: abs(row - middle))
        free = [row for row in rows if self._canvas.is_free(x + 1, row, len(text))]
        self._canvas.text(x + 1, free[0] if free else middle, text, "axle")

    def _draw_wheel(self, wheel: Wheel) -> None:
        _, (hx, hy) = stand(wheel, self._at)
        rows = self._wheel_cells(wheel)
        if wheel.joint.child not in self._given:
            for row, inside in rows:
                for column, _ in inside:
                    self._canvas.put(column, row, "?", "missing")
            return
        # The length of half a cell along the wheel: a mark belongs to the cell it is in.
        reach = max(abs(hx) * self._column, abs(hy) * self._row) / 2
        marks = tread_marks(wheel.radius, spin_of(wheel, self._at), 2 * reach)
        for index, (row, inside) in enumerate(rows):
            character, back = _tread(index - (len(rows) - 1) / 2, hx)
            rims = {}
            if len(inside) > 6 and abs(hx) > _STRAIGHT:
                rims = {inside[0][0]: "(", inside[-1][0]: ")"}
            for column, along in inside:
                shown, style = rims.get(column, "="), "wheel"
                for place, first in marks:
                    ahead = place - along - back * self._column
                    if -reach <= ahead < reach:
                        if first:
                            shown, style = "#", "mark"
                            break
                        if column not in rims:
                            shown = _part_of_cell(ahead / reach, hx) if character == "|" else character
                self._canvas.put(column, row, shown, style)

    def _wheel_cells(self, wheel: Wheel) -> list[tuple[int, list[tuple[int, float]]]]:
        """Return for each row the columns the wheel covers, with their distance along the wheel from its centre (metres)."""
        (x, y), (hx, hy) = stand(wheel, self._at)
        radius, half = max(wheel.radius, self._column / 2), max(wheel.width / 2, self._row / 2)
        columns = range(_nearest(self._x(x - radius - half)), _nearest(self._x(x + radius + half)) + 1)
        rows = []
        for row in range(_nearest(self._y(y + radius + half)), _nearest(self._y(y - radius - half)) + 1):
            dy = -(row - self._y(y)) * self._row
            inside = []
            for column in columns:
                dx = (column - self._x(x)) * self._column
                along, across = (dx * hx + dy * hy) / radius, (dy * hx - dx * hy) / half
                if (math.hypot(along, across) if wheel.ball else max(abs(along), abs(across))) <= 1 + 1e-6:
                    inside.append((column, along * radius))
            if inside:
                rows.append((row, inside))
        return rows or [(_nearest(self._y(y)), [(_nearest(self._x(x)), 0.0)])]

    def _draw_heading(self) -> None:
        """Draw an arrow in front, on the line through the root's origin."""
        column, row = self._cell(self._plan.bounds[2], 0.0)
        self._canvas.text(column + 1, row, "==>", "arrow")

    def _draw_name(self) -> None:
        """Write the name of the chassis inside its rear."""
        for body in self._plan.bodies:
            if body.style == "chassis" and len(body.points) > 1:
                corners = [self._cell(*flat(self._at[body.link], point)) for point in body.points]
                text = self._labels.get(body.link, body.link)
                column, row = min(x for x, _ in corners) + 2, min(y for _, y in corners) + 1
                if cell_width(text) < (max(x for x, _ in corners) - column) / 2:
                    self._canvas.text(column, row, text, "label")
                return

    def _draw_labels(self) -> None:
        for wheel in self._plan.wheels:
            (x, y), _ = stand(wheel, self._at)
            link = wheel.joint.child
            text = self._labels.get(link, link)
            rows = [row for row, _ in self._wheel_cells(wheel)]
            row = rows[0] - 1 if y >= self._middle[1] else rows[-1] + 1
            column = _nearest(self._x(x)) - cell_width(text) // 2
            column = max(min(column, self._canvas.width - cell_width(text)), 0)
            self._canvas.text(column, row, text, self._style(link, "label"))

    def _draw_readings(self) -> None:
        """In a low picture, write the labels without the link's name in the wheel's own row, as many words as fit."""
        for wheel in self._plan.wheels:
            link = wheel.joint.child
            words = self._labels.get(link, "").removeprefix(f"{link} ").split(" ")
            rows = self._wheel_cells(wheel)
            row, inside = rows[len(rows) // 2]
            column = inside[-1][0] + 2
            while words:
                text = " ".join(words)
                if self._canvas.is_free(column, row, cell_width(text)):
                    self._canvas.text(column, row, text, self._style(link, "label"))
                    break
                words.pop()

    def _draw_scale(self) -> None:
        """Draw a bar of a round length in the last row."""
        wanted = self._column * self._canvas.width / 5
        power = 10.0 ** math.floor(math.log10(wanted))
        length = max(step * power for step in (1, 2, 5) if step * power <= wanted)
        cells = _nearest(length / self._column)
        if cells >= 3:
            bar = "|" + "-" * (cells - 1) + "|"
            self._canvas.text(1, self._canvas.height - 1, f"{bar} {length:g} m", "scale")


def _tread(off: float, hx: float) -> tuple[str, int]:
    """Return the character of a tread mark `off` rows below the wheel's centre, and the cells by which it lags there.

    Together the rows form chevrons that point in the rolling direction, as on a tractor's tyre.
    """
    if abs(hx) <= _STRAIGHT or off == 0:
        return "|", 0
    return ("\\" if (off < 0) == (hx > 0) else "/"), int(abs(off))


def _part_of_cell(share: float, hx: float) -> str:
    """Return a vertical stroke at the left, middle or right of its cell; `share` is -1..1 along the rolling direction."""
    if abs(hx) <= _STRAIGHT or abs(share) < 1 / 3:
        return "|"
    return "[" if (share < 0) == (hx > 0) else "]"


def tread_marks(radius: float, spin: float, cell: float) -> list[tuple[float, bool]]:
    """Return the tread marks of the upper half: metres along the wheel from its centre, and True for the first mark.

    The first one is coloured, so that whole turns can be counted. Marks are at least three cells of `cell` metres apart.
    """
    count = min(max(int(2 * math.pi * radius / (3 * cell)), 3), 12) if cell > 0 else 3
    marks = []
    for number in range(count):
        angle = math.remainder(2 * math.pi * number / count + spin, 2 * math.pi)
        if abs(angle) < math.pi / 2:
            marks.append((radius * math.sin(angle), number == 0))
    return sorted(marks, key=lambda mark: not mark[1])


def _nearest(value: float) -> int:
    return math.floor(value + 0.5)
