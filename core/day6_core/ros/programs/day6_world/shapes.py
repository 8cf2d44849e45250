"""Flat geometry: convex outlines and circles, whether they overlap, what a ray hits. Metres; points are (x, y)."""

from __future__ import annotations

import math
from collections.abc import Iterable, Sequence
from dataclasses import dataclass
from functools import cached_property

Point = tuple[float, float]
Segment = tuple[float, float, float, float]


@dataclass(frozen=True)
class Outline:
    """A convex polygon, anticlockwise; with `radius` > 0 and one point, a circle."""

    points: tuple[Point, ...]
    radius: float = 0.0

    @cached_property
    def reach(self) -> tuple[float, float, float]:
        """Middle and radius of a circle that holds it all: most pairs are told apart by it."""
        xs, ys = [x for x, _ in self.points], [y for _, y in self.points]
        x, y = (min(xs) + max(xs)) / 2, (min(ys) + max(ys)) / 2
        return x, y, max(math.hypot(px - x, py - y) for px, py in self.points) + self.radius

    @cached_property
    def sides(self) -> tuple[Segment, ...]:
        points = self.points
        if len(points) < 2:
            return ()
        return tuple((*points[i - 1], *points[i]) for i in range(len(points)))

    def moved(self, x: float, y: float, cosine: float, sine: float) -> Outline:
        """Return it turned about the origin and then shifted."""
        turned = ((x + px * cosine - py * sine, y + px * sine + py * cosine) for px, py in self.points)
        return Outline(tuple(turned), self.radius)


def box(x: float, y: float, length: float, width: float, yaw: float = 0.0) -> Outline:
    """Return a rectangle about its middle, `length` along its heading."""
    half, side = length / 2, width / 2
    corners = ((half, side), (-half, side), (-half, -side), (half, -side))
    return Outline(corners).moved(x, y, math.cos(yaw), math.sin(yaw))


def within_reach(x: float, y: float, reach: float, other: Outline) -> bool:
    """Whether a shape that a circle about (x, y) holds may share a point with another one."""
    ox, oy, other_reach = other.reach
    return math.hypot(ox - x, oy - y) <= reach + other_reach


def overlap(one: Outline, other: Outline) -> bool:
    """Whether two shapes share any point."""
    return within_reach(*one.reach, other) and touch(one, other)


def touch(one: Outline, other: Outline) -> bool:
    """Whether two shapes share any point that are `within_reach` of each other."""
    if len(one.points) == 1 and len(other.points) == 1:
        return True
    if len(one.points) == 1:
        return _circle_touches(one, other)
    if len(other.points) == 1:
        return _circle_touches(other, one)
    return not (_separated(one.points, other.points) or _separated(other.points, one.points))


def _separated(points: Sequence[Point], others: Sequence[Point]) -> bool:
    """Whether a side of the first polygon has all points of the other outside (separating axis)."""
    for i in range(len(points)):
        (ax, ay), (bx, by) = points[i - 1], points[i]
        nx, ny = by - ay, ax - bx  # outwards, for an anticlockwise polygon
        if all((px - ax) * nx + (py - ay) * ny > 0 for px, py in others):
            return True
    return False


def _circle_touches(circle: Outline, polygon: Outline) -> bool:
    x, y = circle.points[0]
    if all((bx - ax) * (y - ay) - (by - ay) * (x - ax) >= 0 for ax, ay, bx, by in polygon.sides):
        return True
    return any(distance(x, y, side) <= circle.radius for side in polygon.sides)


def distance(x: float, y: float, segment: Segment) -> float:
    """Return how far a point is from a straight piece."""
    ax, ay, bx, by = segment
    dx, dy = bx - ax, by - ay
    length = dx * dx + dy * dy
    share = min(max(((x - ax) * dx + (y - ay) * dy) / length, 0.0), 1.0) if length > 0 else 0.0
    return math.hypot(x - ax - share * dx, y - ay - share * dy)


def clearance(x: float, y: float, shapes: Iterable[Outline], around: float) -> float:
    """Return how far a circle of the radius `around` about a point that is in none of the shapes is from all of them, else 0."""
    least = math.inf
    for shape in shapes:
        spots = shape.sides or [(*shape.points[0], *shape.points[0])]
        for side in spots:
            least = min(least, distance(x, y, side) - shape.radius - around)
            if least <= 0:
                return 0.0
    return least


class RayCaster:
    """Finds how far rays from a point reach. Each side looks only at the rays that can hit it, so walls cost little."""

    def __init__(self, shapes: Iterable[Outline]) -> None:
        shapes = list(shapes)
        self._sides = [side for shape in shapes for side in shape.sides]
        self._circles = [(*shape.points[0], shape.radius) for shape in shapes if len(shape.points) == 1]

    def cast(self, x: float, y: float, first: float, step: float, count: int, longest: float) -> list[float]:
        """Return the lengths of `count` rays from `first` (radians) on, `step` apart; inf for those that hit nothing."""
        ranges = [math.inf] * count
        angles = [first + index * step for index in range(count)]
        ways = list(zip(map(math.cos, angles), map(math.sin, angles), strict=True))
        for ax, ay, bx, by in self._sides:
            _cast_side(ax - x, ay - y, bx - x, by - y, first, step, ways, ranges, longest)
        for cx, cy, radius in self._circles:
            _cast_circle(cx - x, cy - y, radius, first, step, ranges, longest)
        return ranges


def _cast_side(
    ax: float,
    ay: float,
    bx: float,
    by: float,
    first: float,
    step: float,
    ways: list[Point],
    ranges: list[float],
    longest: float,
) -> None:
    cross = ax * by - ay * bx
    if abs(cross) < 1e-12:
        return
    start, end = (math.atan2(ay, ax), math.atan2(by, bx)) if cross > 0 else (math.atan2(by, bx), math.atan2(ay, ax))
    nx, ny = by - ay, ax - bx
    for index in _between(start, end, first, step, len(ranges)):
        cosine, sine = ways[index]
        along = nx * cosine + ny * sine
        if abs(along) > 1e-12:
            length = cross / along
            if 0 <= length <= longest and length < ranges[index]:
                ranges[index] = length


def _between(start: float, end: float, first: float, step: float, count: int) -> Iterable[int]:
    """Return the numbers of the rays in the angle from `start` to `end`, anticlockwise and less than half a turn."""
    width = math.remainder(end - start, 2 * math.pi)
    offset = (start - first) % (2 * math.pi)
    turn = round(2 * math.pi / step)
    low, high = math.ceil(offset / step - 1e-9), math.floor((offset + width) / step + 1e-9)
    for number in range(low, high + 1):
        index = number % turn
        if index < count:
            yield index


def _cast_circle(
    cx: float, cy: float, radius: float, first: float, step: float, ranges: list[float], longest: float
) -> None:
    away = math.hypot(cx, cy)
    if away <= radius:
        return
    half = math.asin(radius / away)
    middle = math.atan2(cy, cx)
    for index in _between(middle - half, middle + half, first, step, len(ranges)):
        angle = first + index * step - middle
        length = away * math.cos(angle) - math.sqrt(max(radius**2 - (away * math.sin(angle)) ** 2, 0.0))
        if length <= longest and length < ranges[index]:
            ranges[index] = length
