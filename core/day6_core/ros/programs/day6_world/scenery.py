"""World files: the objects on the floor, the line on it, and the robot's start. YAML, read safely.

name: yard
size: [6, 4]                      # of the floor in metres, (0, 0) in its middle; with `border: true` walled in
start: {x: -2, y: 0, yaw: 0}      # metres, degrees
walls:                            # straight pieces
  - {from: [0, 1], to: [2, 1], thickness: 0.1}
boxes:
  - {x: 1, y: -1, size: [0.4, 0.3], yaw: 30}
cylinders:
  - {x: -1, y: 1, radius: 0.2}
line: {points: [[-2, 0], [2, 0]], width: 0.05, closed: false, smooth: 2}
"""

from __future__ import annotations

import math
import os
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from day6_core.ros.programs.day6_world.shapes import Outline, Point, Segment, box

MAX_BYTES = 200_000
MAX_SHAPES = 2_000
MAX_METRES = 200.0


class SceneryError(Exception):
    """A world file cannot be used; the text says where and why."""


@dataclass(frozen=True)
class Scenery:
    """The floor's size in metres, what stands on it, the line as straight pieces, and the robot's start (x, y, yaw)."""

    name: str
    size: tuple[float, float]
    solids: tuple[Outline, ...] = ()
    line: tuple[Segment, ...] = ()
    line_width: float = 0.05
    start: tuple[float, float, float] = (0.0, 0.0, 0.0)


def shipped_worlds(share: Path) -> dict[str, Path]:
    """Return the world files that come with the package, by name."""
    return {path.stem: path for path in sorted((share / "worlds").glob("*.yaml"))}


def read_scenery(path: str | os.PathLike[str]) -> Scenery:
    """Read a world file. Raises SceneryError, OSError."""
    import yaml

    with open(path, "rb") as file:
        data = file.read(MAX_BYTES + 1)
    if len(data) > MAX_BYTES:
        raise SceneryError(f"a world file of more than {MAX_BYTES // 1000} kB is not read")
    text = data.decode("utf-8", "replace")
    try:
        if any(isinstance(event, yaml.AliasEvent) for event in yaml.parse(text, Loader=yaml.SafeLoader)):
            raise SceneryError("aliases (*name) are not allowed in a world file")
        content = yaml.safe_load(text)
    except (yaml.YAMLError, RecursionError) as error:
        raise SceneryError(f"no YAML: {error}") from error
    return scenery_of(content, Path(path).stem)


def scenery_of(content: Any, name: str) -> Scenery:
    """Return the scenery that a world file's content describes. Raises SceneryError."""
    top = _Part(content, "world")
    size = top.pair("size", (6.0, 6.0))
    if min(size) <= 0:
        raise SceneryError("size: both lengths have to be greater than 0")
    solids = [_wall(part) for part in top.parts("walls")]
    solids += [_box(part) for part in top.parts("boxes")]
    solids += [_cylinder(part) for part in top.parts("cylinders")]
    if top.flag("border", True):
        solids += _border(*size)
    start = top.part("start")
    line = top.part("line")
    pieces, width = _line(line)
    top.nothing_else("name size start walls boxes cylinders border line")
    pose = (start.number("x", 0.0), start.number("y", 0.0), math.radians(start.number("yaw", 0.0)))
    return Scenery(str(top.content.get("name", name)), size, tuple(solids), pieces, width, pose)


def _wall(part: _Part) -> Outline:
    (ax, ay), (bx, by) = part.pair("from"), part.pair("to")
    length, thickness = math.hypot(bx - ax, by - ay), part.positive("thickness", 0.1)
    return box((ax + bx) / 2, (ay + by) / 2, length + thickness, thickness, math.atan2(by - ay, bx - ax))


def _box(part: _Part) -> Outline:
    length, width = part.pair("size")
    if length <= 0 or width <= 0:
        raise SceneryError(f"{part.where}.size: both lengths have to be greater than 0")
    return box(part.number("x"), part.number("y"), length, width, math.radians(part.number("yaw", 0.0)))


def _cylinder(part: _Part) -> Outline:
    return Outline(((part.number("x"), part.number("y")),), part.positive("radius"))


def _border(length: float, width: float) -> list[Outline]:
    t = 0.1
    x, y = (length + t) / 2, (width + t) / 2
    across, along = length + 2 * t, width + 2 * t
    return [box(0, y, across, t), box(0, -y, across, t), box(x, 0, t, along), box(-x, 0, t, along)]


def _line(part: _Part) -> tuple[tuple[Segment, ...], float]:
    points = [part.point(value, f"points[{i}]") for i, value in enumerate(part.items("points"))]
    closed = part.flag("closed", False)
    for _ in range(min(int(part.number("smooth", 0.0)), 5)):
        points = _rounded(points, closed)
    ends = points[1:] + points[:1] if closed else points[1:]
    pieces = tuple((*a, *b) for a, b in zip(points, ends, strict=False))
    return pieces, part.positive("width", 0.05)


def _rounded(points: list[Point], closed: bool) -> list[Point]:
    """Cut every corner at a quarter of its sides (Chaikin); the ends of an open line stay."""
    pairs = list(zip(points, points[1:] + points[:1] if closed else points[1:], strict=False))
    cut = [
        ((1 - share) * ax + share * bx, (1 - share) * ay + share * by)
        for (ax, ay), (bx, by) in pairs
        for share in (0.25, 0.75)
    ]
    return cut if closed or len(points) < 3 else [points[0], *cut[1:-1], points[-1]]


class _Part:
    """One mapping of the file with its path, so that every error names its place."""

    def __init__(self, content: Any, where: str) -> None:
        if not isinstance(content, dict):
            raise SceneryError(f"{where}: names and values are expected here, not {type(content).__name__}")
        self.content: dict[Any, Any] = content
        self.where = where

    def nothing_else(self, known: str) -> None:
        for key in self.content:
            if key not in known.split():
                raise SceneryError(f"{self.where}: '{key}' is not known here ({', '.join(known.split())} are)")

    def items(self, key: str) -> list[Any]:
        value = self.content.get(key) or []
        if not isinstance(value, list) or len(value) > MAX_SHAPES:
            raise SceneryError(f"{self.where}.{key}: a list of at most {MAX_SHAPES} is expected")
        return value

    def parts(self, key: str) -> list[_Part]:
        return [_Part(value, f"{key}[{i}]") for i, value in enumerate(self.items(key))]

    def part(self, key: str) -> _Part:
        return _Part(self.content.get(key) or {}, key)

    def flag(self, key: str, default: bool) -> bool:
        return bool(self.content.get(key, default))

    def number(self, key: str, default: float | None = None) -> float:
        value = self.content.get(key, default)
        return _metres(value, f"{self.where}.{key}")

    def positive(self, key: str, default: float | None = None) -> float:
        value = self.number(key, default)
        if value <= 0:
            raise SceneryError(f"{self.where}.{key}: has to be greater than 0")
        return value

    def pair(self, key: str, default: Point | None = None) -> Point:
        return self.point(self.content.get(key, default), key)

    def point(self, value: Any, key: str) -> Point:
        if not isinstance(value, (list, tuple)) or len(value) != 2:
            raise SceneryError(f"{self.where}.{key}: two numbers are expected, like [1.0, 2.0]")
        return _metres(value[0], f"{self.where}.{key}"), _metres(value[1], f"{self.where}.{key}")


def _metres(value: Any, where: str) -> float:
    good = isinstance(value, (int, float)) and not isinstance(value, bool) and math.isfinite(value)
    # Angles are in degrees and up to 360; lengths are bounded so that no picture and no ray runs away.
    if not good or abs(value) > max(MAX_METRES, 360.0):
        raise SceneryError(f"{where}: a number is expected, not {value!r}")
    return float(value)
