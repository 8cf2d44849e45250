"""Where a robot seen from above lies in a picture, and how large its wheels are drawn there.

A picture has `columns` x `rows` cells of some dots each: 1 x 2 with half blocks, 2 x 4 with braille, 1 x 1 with whole cells and
letters, many with real pixels. Everything is to scale but for one thing: a wheel is the part that one looks at, so where it
would be too thin to show its tread it is drawn thicker and longer, and stands further out instead of covering the body.
"""

from __future__ import annotations

import math
from collections.abc import Mapping
from dataclasses import dataclass

from day6_urdf.kinematics import Transform
from day6_urdf.topview.plan import TopPlan, Wheel, flat, stand

STRAIGHT = 0.98
"""Cosine of the angle to an axis of the picture above which a wheel counts as parallel to it."""

ARROW_COLUMNS = 6
"""In front of the robot, for the arrow."""

_PROUD = 0.12
"""Part of the picture's height that a wheel's thickness may grow to, up to half as thick again as in life."""

_ROOM_FOR_THICK = 8
"""Rows of a picture below which no wheel is thicker than a row."""

Spot = tuple[float, float]


@dataclass(frozen=True, slots=True)
class Tyre:
    """A wheel as it is drawn: its centre, the direction its top moves in, half its length and thickness (metres, root frame)."""

    wheel: Wheel
    x: float
    y: float
    heading: Spot
    half_length: float
    half_width: float

    @property
    def straight(self) -> bool:
        """Whether it is parallel to the robot's x axis."""
        return abs(self.heading[0]) > STRAIGHT

    def strip(self, start: float, end: float, share: float = 1.0) -> list[Spot]:
        """The corners of a part of it between two distances along it from its centre, over a share of its thickness."""
        (hx, hy), side = self.heading, self.half_width * share
        if self.straight:
            hx, hy = math.copysign(1.0, hx), 0.0  # upright corners, for pictures of few dots
        corners = ((start, -side), (end, -side), (end, side), (start, side))
        return [(self.x + hx * a - hy * b, self.y + hy * a + hx * b) for a, b in corners]

    def reach(self) -> Spot:
        """How far it extends from its centre along x and along y."""
        hx, hy = abs(self.heading[0]), abs(self.heading[1])
        if self.wheel.ball:
            return self.half_length, self.half_length
        return hx * self.half_length + hy * self.half_width, hy * self.half_length + hx * self.half_width


def life_size(plan: TopPlan, at: Mapping[str, Transform]) -> list[Tyre]:
    """The wheels where `at` has them, as large as they are."""
    return [Tyre(w, *spot, heading, w.radius, w.width / 2) for w in plan.wheels for spot, heading in [stand(w, at)]]


class TopFrame:
    """The robot of `plan` in `columns` x `rows` cells of `dots` (across, down); the robot faces right.

    A cell is `shape` times as high as wide. Wheels are at least `thick` rows thick where there is room, and
    `longer` times as long where that is more than life. `zoom` enlarges about the
    middle, at 1 everything fits; `shift` moves by columns and rows.
    """

    def __init__(
        self,
        plan: TopPlan,
        columns: int,
        rows: int,
        dots: tuple[int, int] = (1, 1),
        *,
        thick: float = 1.5,
        longer: float = 1.2,
        shape: float = 2.0,
        zoom: float = 1.0,
        shift: tuple[int, int] = (0, 0),
    ) -> None:
        self.plan, self.columns, self.rows, self.dots = plan, columns, rows, dots
        self.width, self.height = columns * dots[0], rows * dots[1]
        self.squash = shape * dots[0] / dots[1]
        """How many times as high as wide a dot is."""
        self._thick = (thick if rows >= _ROOM_FOR_THICK else min(thick, 1.0)) * dots[1]
        self._longer = longer
        self._side = self._sides_of_the_chassis()
        self._rest = life_size(plan, plan.rest)
        self._apart = _distances(self._rest)
        margin = (ARROW_COLUMNS if columns > 3 * ARROW_COLUMNS else 1) * dots[0]
        free_x, free_y = max(self.width - margin - dots[0], 1), max(self.height - (dots[1] if rows > 4 else 0), 1)
        left, bottom, right, top = plan.bounds
        self.metre = 1.0
        """Dots across a metre."""
        for _ in range(5):  # the wheels' thickness depends on the scale, and the scale on the room they need
            metre = min(free_x / max(right - left, 1e-6), self.squash * free_y / max(top - bottom, 1e-6))
            self.metre = min(max(metre, 1e-300), 1e9)
            left, bottom, right, top = self._extent(plan.bounds)
        self.front = right
        self._middle = (left + right) / 2, (bottom + top) / 2
        self.metre *= max(zoom, 0.01)
        # A whole number of dots, so that what is alike on both sides of the robot looks alike.
        self._zero = (
            round((self.width - margin) / 2) + shift[0] * dots[0],
            round(self.height / 2) + shift[1] * dots[1],
        )

    # -- places --------------------------------------------------------------------------------------------------------

    def place(self, spot: Spot) -> Spot:
        """The dots of a point (metres, root frame) from the upper left corner, with fractions."""
        x, y = spot
        return (
            self._zero[0] + (x - self._middle[0]) * self.metre,
            self._zero[1] - (y - self._middle[1]) * self.metre / self.squash,
        )

    def snapped(self, spot: Spot) -> tuple[int, int]:
        """The nearest corner between dots; halves go away from the middle, so that left and right of the robot are alike."""
        x, y = self.place(spot)
        return math.floor(x + 0.5 + 1e-6), self._zero[1] + _outwards(y - self._zero[1])

    def cell(self, spot: Spot) -> tuple[int, int]:
        """Column and row of a point."""
        x, y = self.place(spot)
        return math.floor(x / self.dots[0]), math.floor(y / self.dots[1])

    @property
    def down(self) -> float:
        """Dots down a metre."""
        return self.metre / self.squash

    # -- wheels --------------------------------------------------------------------------------------------------------

    def tyres(self, at: Mapping[str, Transform]) -> list[Tyre]:
        """The wheels where `at` has them, as large as they are drawn."""
        return [self._drawn(tyre) for tyre in life_size(self.plan, at)]

    def _drawn(self, life: Tyre) -> Tyre:
        """A wheel as large as it is drawn."""
        wheel, x, y, heading = life.wheel, life.x, life.y, life.heading
        if wheel.ball:
            half = max(wheel.radius, 1.0 / self.metre)
            return Tyre(wheel, x, y, heading, half, half)
        across = abs(heading[0]) * self.down + abs(heading[1]) * self.metre  # dots of a metre of its thickness
        along = abs(heading[0]) * self.metre + abs(heading[1]) * self.down
        thick = self._thick * (self.squash if abs(heading[1]) > abs(heading[0]) else 1.0)
        width = wheel.width * across
        dots = max(width, min(1.5 * width, _PROUD * self.height), thick)
        longer = self._longer if dots > 1.2 * width else 1.0
        if abs(heading[0]) <= STRAIGHT:
            return Tyre(wheel, x, y, heading, max(wheel.radius * longer, 2.5 / along), dots / across / 2)
        # Whole dots in both directions: otherwise its outline would change with its place.
        # But not into the next one.
        long = max(2 * wheel.radius, min(2 * wheel.radius * longer, self._apart[wheel.joint.name] - 1.5 / along))
        half_length = max(round(long * along), 3) / along / 2
        half_width = max(round(dots), 1) / across / 2
        return Tyre(
            wheel, x, self._beside_the_chassis(y, wheel.width / 2, half_width), heading, half_length, half_width
        )

    def _beside_the_chassis(self, y: float, half: float, drawn: float) -> float:
        """The y of a wheel that is drawn thicker than its `half`: further out if it stands beside the chassis, not under it."""
        low, high = self._side
        gap = 1.0 / self.down
        if y - half >= high - 1e-9:
            return max(y, high + gap + drawn)
        if y + half <= low + 1e-9:
            return min(y, low - gap - drawn)
        return y

    def _sides_of_the_chassis(self) -> tuple[float, float]:
        """The least and the greatest y of the chassis at rest."""
        ys = [0.0]
        for body in self.plan.bodies:
            if body.style == "chassis":
                spots = [flat(self.plan.rest[body.link], point)[1] for point in body.points]
                ys += [min(spots) - body.radius, max(spots) + body.radius]
        return min(ys), max(ys)

    def _extent(self, bounds: tuple[float, float, float, float]) -> tuple[float, float, float, float]:
        """The bounds with the wheels as they are drawn at the present scale."""
        left, bottom, right, top = bounds
        for life in self._rest:
            tyre = self._drawn(life)
            across, up = tyre.reach()
            left, right = min(left, tyre.x - across), max(right, tyre.x + across)
            bottom, top = min(bottom, tyre.y - up), max(top, tyre.y + up)
        return left, bottom, right, top


def _distances(tyres: list[Tyre]) -> dict[str, float]:
    """How far each wheel's middle is from that of the nearest one before or behind it, by joint (metres)."""
    apart = {}
    for tyre in tyres:
        same_side = [o for o in tyres if o is not tyre and abs(o.y - tyre.y) < tyre.half_width + o.half_width]
        apart[tyre.wheel.joint.name] = min((abs(other.x - tyre.x) for other in same_side), default=math.inf)
    return apart


def _outwards(value: float) -> int:
    return int(math.copysign(math.floor(abs(value) + 0.5 + 1e-6), value))
