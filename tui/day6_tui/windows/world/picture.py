"""The world from above as pixels: floor, line, trail, walls, rays and the robot to scale, for every set of characters.

Pixels are kinds (WALL, BODY …), one byte each; the style of a kind is chosen when lines are made of them. The parts
that do not move are painted once per view, the moving ones over a copy of it.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Iterable, Mapping, Sequence
from dataclasses import dataclass
from itertools import groupby
from typing import TYPE_CHECKING

from rich.segment import Segment
from rich.style import Style

from day6_tui.appearance.colours import Colours, background_of, pixel_style
from day6_urdf.topview.paint import tread_marks
from day6_urdf.topview.plan import Body, TopPlan, Wheel, flat, hull, plan_top, spin_of, stand

if TYPE_CHECKING:
    from day6_core.ros.programs.day6_world.model import Scan, Trail, WorldSnapshot
    from day6_core.ros.programs.day6_world.scenery import Scenery
    from day6_urdf.kinematics import Transform
    from day6_urdf.model import Robot

FLOOR, OUTSIDE, GRID, LINE, TRAIL, BEAM, HIT, WALL, CHASSIS, BODY, WHEEL, TREAD, FIRST_TREAD, CASTER, NOSE, FIRM = (
    range(16)
)

_CHARACTERS = "  +=.-*#%%H|!o"
"""Characters of the kinds up to CASTER, where there are no pixels; the nose shows the robot's heading."""

_COLOURS = {  # dark theme, light theme
    FLOOR: (0x1B222C, 0xF1F3F5),
    OUTSIDE: (0x12161D, 0xFAFBFC),
    GRID: (0x36414F, 0xC9D0D8),
    LINE: (0xE8E3C8, 0x22272E),
    TRAIL: (0xF0B429, 0xC27700),
    BEAM: (0x24423D, 0xCFE8DF),
    HIT: (0x3FC9A0, 0x00906A),
    WALL: (0x8C97A6, 0x5D6B7D),
    CHASSIS: (0x4C6FE8, 0x2F55D4),
    BODY: (0x7FA0F5, 0x6F8DE8),
    WHEEL: (0x5A5F66, 0x3A3F46),
    TREAD: (0x9AA1AB, 0x9AA1AB),
    FIRST_TREAD: (0xFF9B5E, 0xFF8A3C),
    CASTER: (0xC4CAD2, 0x8A929C),
    NOSE: (0xFFFFFF, 0xFFFFFF),
    FIRM: (0xFF6A4D, 0xD23A1A),
}

Rows = list[bytearray]
Points = Sequence[tuple[float, float]]
Placing = Callable[[Iterable[tuple[float, float]]], list[tuple[float, float]]]
"""Moves points of the robot to where it stands."""


@dataclass(frozen=True)
class WorldView:
    """The visible part: its middle in metres, metres per pixel across, and the number of cells."""

    x: float
    y: float
    scale: float
    columns: int
    rows: int
    mode: str

    @property
    def width(self) -> int:
        return self.columns

    @property
    def height(self) -> int:
        return self.rows * (2 if self.mode == "half" else 1)

    @property
    def scale_y(self) -> float:
        """Metres for one pixel down: a pixel is square where two of them share a cell, else twice as high as wide."""
        return self.scale if self.mode == "half" else 2 * self.scale

    def pixel(self, x: float, y: float) -> tuple[float, float]:
        return (x - self.x) / self.scale + self.width / 2, self.height / 2 - (y - self.y) / self.scale_y

    def holds(self, x: float, y: float, margin: float) -> bool:
        """Whether a point is inside, by at least this share of the picture."""
        px, py = self.pixel(x, y)
        mx, my = margin * self.width, margin * self.height
        return mx <= px <= self.width - mx and my <= py <= self.height - my


def fitting(scenery: Scenery, columns: int, rows: int, mode: str) -> WorldView:
    """The view that shows the whole floor, with the walls around it."""
    length, width = (side + 0.3 for side in scenery.size)
    high = rows * 2  # a cell is twice as high as wide, so in columns
    return WorldView(0.0, 0.0, max(length / max(columns, 1), width / max(high, 1)), columns, rows, mode)


class WorldPicture:
    """The pixels of one view. `frame` gives the rows of a snapshot, `segments` the line of a cell row."""

    def __init__(self, view: WorldView, scenery: Scenery) -> None:
        self.view = view
        self._base = self._paint_scenery(scenery)
        self._trail: Rows | None = None
        self._trail_key = (-1, 0)
        self._scan: Rows | None = None
        self._scan_key: tuple[object, ...] = ()
        self._plan: TopPlan | None = None

    # -- what stands still ---------------------------------------------------------------------------------------------

    def _paint_scenery(self, scenery: Scenery) -> Rows:
        view = self.view
        rows = [bytearray([OUTSIDE]) * view.width for _ in range(view.height)]
        x, y = scenery.size[0] / 2, scenery.size[1] / 2
        self._fill(rows, [(-x, -y), (x, -y), (x, y), (-x, y)], FLOOR)
        for mx in range(math.ceil(-x), math.floor(x) + 1):
            for my in range(math.ceil(-y), math.floor(y) + 1):
                self._dots(rows, [(mx, my)], GRID)
        half = scenery.line_width / 2
        for ax, ay, bx, by in scenery.line:
            self._fill(rows, _bar((ax, ay), (bx, by), half), LINE)
            # A line thinner than a pixel must not have gaps where it passes between the middles of two.
            steps = max(1, math.ceil(math.hypot(bx - ax, by - ay) / view.scale * 2))
            shares = [step / steps for step in range(steps + 1)]
            self._dots(rows, [(ax + (bx - ax) * share, ay + (by - ay) * share) for share in shares], LINE)
        for solid in scenery.solids:
            self._fill(rows, _corners(solid.points, solid.radius), WALL)
        return rows

    def _with_trail(self, trail: Trail) -> Rows:
        """The base with the trail on it; new points are added to what is there."""
        points = trail.points
        generation, count = self._trail_key
        if self._trail is None or generation != trail.generation or len(points) < count:
            self._trail, count = [bytearray(row) for row in self._base], 0
        self._dots(self._trail, points[count:], TRAIL, over=(FLOOR, OUTSIDE, GRID))
        self._trail_key = (trail.generation, len(points))
        return self._trail

    def _with_scan(self, trail: Trail, scan: Scan | None) -> Rows:
        """All that the robot stands on: there are more pictures than scans."""
        rows = self._with_trail(trail)
        if scan is None:
            return rows
        if self._scan is None or self._scan_key != (self._trail_key, scan):
            self._scan, self._scan_key = [bytearray(row) for row in rows], (self._trail_key, scan)
            self._draw_scan(self._scan, scan)
        return self._scan

    # -- a moment ------------------------------------------------------------------------------------------------------

    def frame(self, snapshot: WorldSnapshot, trail: Trail) -> Rows:
        """The pixel rows of a moment."""
        rows = [bytearray(row) for row in self._with_scan(trail, snapshot.scan)]
        if snapshot.robot is not None:
            self._draw_robot(rows, snapshot, snapshot.robot)
        return rows

    def _draw_scan(self, rows: Rows, scan: Scan) -> None:
        x, y, step = scan.x, scan.y, self.view.scale_y
        angles = [scan.first + number * scan.step for number in range(len(scan.ranges))]
        rays = [(length, math.cos(angle), math.sin(angle)) for length, angle in zip(scan.ranges, angles, strict=True)]
        for length, cosine, sine in rays[::6]:
            alongs = [each * step for each in range(int(min(length, 20.0) / step))]
            beam = [(x + along * cosine, y + along * sine) for along in alongs]
            self._dots(rows, beam, BEAM, over=(FLOOR, OUTSIDE, GRID))
        ends = [(x + length * cosine, y + length * sine) for length, cosine, sine in rays if math.isfinite(length)]
        self._dots(rows, ends, HIT)

    def _draw_robot(self, rows: Rows, snapshot: WorldSnapshot, robot: Robot) -> None:
        plan = self._plan
        if plan is None or plan.robot is not robot:
            plan = self._plan = plan_top(robot)
        place = placing(snapshot.pose)
        at = {**plan.rest, **snapshot.transforms()}
        for body, kind in bodies_of(plan):
            spots = [flat(at[body.link], point) for point in body.points]
            if len(spots) > 1:
                self._fill(rows, place(hull(spots)), kind)
            elif body.radius > 0:
                self._fill(rows, _corners(place(spots), body.radius), kind)
        for wheel in plan.wheels:
            self._draw_wheel(rows, wheel, at, place)
        nose = place(nose_of(plan))
        self._fill(rows, nose, NOSE)
        self._dots(rows, [nose[1]], FIRM if snapshot.bumped else NOSE)

    def _draw_wheel(self, rows: Rows, wheel: Wheel, at: Mapping[str, Transform], place: Placing) -> None:
        (cx, cy), (hx, hy) = stand(wheel, at)
        half = wheel.width / 2

        def across(start: float, end: float) -> list[tuple[float, float]]:
            sides = ((start, -half), (end, -half), (end, half), (start, half))
            return [(cx + hx * a - hy * b, cy + hy * a + hx * b) for a, b in sides]

        self._fill(rows, place(across(-wheel.radius, wheel.radius)), WHEEL)
        pixel = self.view.scale
        if wheel.radius < 3 * pixel:
            return
        for along, first in tread_marks(wheel.radius, spin_of(wheel, at), pixel):
            mark = across(along - pixel / 4, along + pixel / 4)
            self._fill(rows, place(mark), FIRST_TREAD if first else TREAD)

    # -- pixels --------------------------------------------------------------------------------------------------------

    def _dots(
        self, rows: Rows, points: Iterable[tuple[float, float]], kind: int, over: Iterable[int] = range(16)
    ) -> None:
        """Set the pixels in which points are, where one of the kinds `over` is."""
        view, width, height = self.view, self.view.width, self.view.height
        middle_x, middle_y, scale, scale_y = view.x, view.y, view.scale, view.scale_y
        left, top, over = width / 2, height / 2, frozenset(over)
        for x, y in points:
            px, py = (x - middle_x) / scale + left, top - (y - middle_y) / scale_y
            if 0 <= px < width and 0 <= py < height:
                row, column = rows[int(py)], int(px)
                if row[column] in over:
                    row[column] = kind

    def _fill(self, rows: Rows, points: Points, kind: int) -> None:
        """Fill a convex polygon (metres): every pixel whose middle is in it, and where it is thin at least one."""
        corners = [self.view.pixel(*point) for point in points]
        sides = list(zip(corners, corners[1:] + corners[:1], strict=True))
        top, bottom = min(y for _, y in corners), max(y for _, y in corners)
        first, last = math.floor(top + 0.5), math.ceil(bottom - 0.5)
        if first >= last:
            first = math.floor((top + bottom) / 2)
            last = first + 1
        for row in range(max(first, 0), min(last, self.view.height)):
            span = _span(sides, min(max(row + 0.5, top), bottom))
            if span is None:
                continue
            left, right = math.floor(span[0] + 0.5), math.ceil(span[1] - 0.5)
            if left >= right:
                left = math.floor((span[0] + span[1]) / 2)
                right = left + 1
            left, right = max(left, 0), min(right, self.view.width)
            if left < right:
                rows[row][left:right] = bytes([kind]) * (right - left)


def _span(sides: list[tuple[tuple[float, float], tuple[float, float]]], y: float) -> tuple[float, float] | None:
    """Where a level line enters and leaves a convex polygon."""
    cuts = []
    for (ax, ay), (bx, by) in sides:
        if ay == by:
            if ay == y:
                cuts += [ax, bx]
        elif min(ay, by) <= y <= max(ay, by):
            cuts.append(ax + (bx - ax) * (y - ay) / (by - ay))
    return (min(cuts), max(cuts)) if cuts else None


def _corners(points: Points, radius: float) -> Points:
    """A polygon's corners; of a circle so many that it looks round."""
    if radius <= 0 or len(points) != 1:
        return points
    (x, y), count = points[0], 20
    turns = (2 * math.pi * i / count for i in range(count))
    return [(x + radius * math.cos(turn), y + radius * math.sin(turn)) for turn in turns]


def _bar(start: tuple[float, float], end: tuple[float, float], half: float) -> Points:
    """A straight piece with a width, a little longer so that pieces join."""
    (ax, ay), (bx, by) = start, end
    length = math.hypot(bx - ax, by - ay) or 1.0
    ux, uy = (bx - ax) / length * half, (by - ay) / length * half
    return [
        (ax - ux + uy, ay - uy - ux),
        (bx + ux + uy, by + uy - ux),
        (bx + ux - uy, by + uy + ux),
        (ax - ux - uy, ay - uy + ux),
    ]


# -- the robot, for any kind of pixels ---------------------------------------------------------------------------------


def placing(pose: tuple[float, float, float]) -> Placing:
    """How points of a robot move to its pose: x and y in metres, yaw in radians."""
    x, y, yaw = pose
    cosine, sine = math.cos(yaw), math.sin(yaw)
    return lambda points: [(x + px * cosine - py * sine, y + px * sine + py * cosine) for px, py in points]


def bodies_of(plan: TopPlan) -> list[tuple[Body, int]]:
    """The bodies in the order in which they are drawn, and their kinds."""
    kinds = {"chassis": CHASSIS, "caster": CASTER}
    return [(body, kinds.get(body.style, BODY)) for body in plan.bodies]


def nose_of(plan: TopPlan) -> Points:
    """The triangle that shows where the robot's front is; its tip is the point in the middle."""
    left, low, right, high = plan.bounds
    size, middle = (right - left) * 0.18, (low + high) / 2
    return [(right - size, middle - size / 2), (right, middle), (right - size, middle + size / 2)]


# -- lines -------------------------------------------------------------------------------------------------------------


def look_of(colours: Colours) -> list[int]:
    """The colour of every kind."""
    theme = 0 if colours.dark else 1
    table = [_COLOURS[kind][theme] for kind in range(len(_COLOURS))]
    background = background_of(colours.text)
    if background >= 0:
        table[OUTSIDE] = background
    return table


def segments(rows: Rows, line: int, view: WorldView, table: list[int], colours: Colours, yaw: float) -> list[Segment]:
    """The segments of one line of cells."""
    if view.mode == "half":
        pairs = zip(rows[2 * line], rows[2 * line + 1], strict=True)
        return [_half(top, bottom, len(list(run)), table) for (top, bottom), run in groupby(pairs)]
    if view.mode == "cell":
        return [Segment(" " * len(list(run)), pixel_style(-1, table[kind])) for kind, run in groupby(rows[line])]
    return [Segment(_character(kind, yaw) * len(list(run)), _role(kind, colours)) for kind, run in groupby(rows[line])]


def _half(top: int, bottom: int, count: int, table: list[int]) -> Segment:
    if table[top] == table[bottom]:
        return Segment(" " * count, pixel_style(-1, table[top]))
    return Segment("▀" * count, pixel_style(table[top], table[bottom]))


def _character(kind: int, yaw: float) -> str:
    if kind == FIRM:
        return "X"
    if kind == NOSE:
        return ">/^\\</v\\"[round(yaw / (math.pi / 4)) % 8]
    return _CHARACTERS[kind]


_ROLES = {
    TRAIL: "topic", LINE: "strong", HIT: "publisher", WALL: "text", CHASSIS: "node", BODY: "node", WHEEL: "strong",
    TREAD: "topic", FIRST_TREAD: "topic", NOSE: "accent", FIRM: "warning",
}  # fmt: skip


def _role(kind: int, colours: Colours) -> Style:
    style: Style = getattr(colours, _ROLES.get(kind, "muted"))
    return style
