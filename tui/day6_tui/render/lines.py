"""Lines and points: sampled pixel by pixel, all segments at once."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np

from day6_core.ros.programs.rviz2.model.scene import Lines, Points
from day6_core.ros.programs.rviz2.model.turning import matrix
from day6_tui.render.picture import LINE, SURFACE, Array, Projection, RenderedPicture

BIAS = 0.004
"""Lines on a surface are drawn over it: their depth counts as nearer by this fraction of itself."""

MOST_SAMPLES = 400_000
WIDEST_POINT = 9


def ends_of(lines: Lines) -> Array:
    """The ends of all segments in the fixed frame: N x 2 x 3."""
    count = len(lines.vertices) // 2
    turn = np.array(matrix(lines.pose.rotation))
    points = np.asarray(lines.vertices, np.float64)[: 2 * count] @ turn.T + np.array(lines.pose.xyz)
    ends: Array = points.reshape(count, 2, 3)
    return ends


class Segments:
    """Collects segments from many sources, to be painted in one go."""

    def __init__(self) -> None:
        self._ends: list[Array] = []
        self._colours: list[Array] = []

    def add(self, start: Array, end: Array, colour: Sequence[float]) -> None:
        """One segment of one colour."""
        self._ends.append(np.array([[start, end]], np.float64))
        self._colours.append(np.array([[colour, colour]], np.float32))

    def extend(self, lines: Lines) -> None:
        """All segments of a `Lines`."""
        count = len(lines.vertices) // 2
        if not count:
            return
        ends = ends_of(lines)
        colours = np.asarray(lines.colours, np.float32)
        if len(colours) == 2 * count and count:
            pairs = colours.reshape(count, 2, 4)
        else:
            pairs = np.broadcast_to(colours[0], (count, 2, 4))
        self._ends.append(ends)
        self._colours.append(pairs)

    def paint(self, picture: RenderedPicture) -> None:
        """Put them all into the picture."""
        if not self._ends:
            return
        ends, colours = np.concatenate(self._ends), np.concatenate(self._colours)
        good = np.isfinite(ends).all(axis=(1, 2))
        _paint(picture, picture.seen(ends[good].reshape(-1, 3)).reshape(-1, 2, 3), colours[good])


@dataclass(frozen=True)
class OnScreen:
    """Segments with their visible parts: from (x, y, z)[0] to (x, y, z)[1] in pixels, visible for `low` < t < `high`."""

    x: tuple[Array, Array]
    y: tuple[Array, Array]
    z: tuple[Array, Array]
    low: Array
    high: Array
    number: Array
    """Which of the segments that were given these are."""

    def depth(self, picture: Projection, which: Array, t: Array) -> Array:
        """The depths of places `t` of the segments `which`."""
        z0, z1 = self.z[0][which], self.z[1][which]
        # Along a projected line 1/z is linear.
        depth: Array = z0 + (z1 - z0) * t if picture.parallel else 1 / (1 / z0 + (1 / z1 - 1 / z0) * t)
        return depth


def on_screen(picture: Projection, seen: Array) -> OnScreen | None:
    """Project segments (N x 2 x 3 in the camera's axes); None if nothing of them is in the picture."""
    near = picture.near
    depth = seen[..., 2]
    number = np.flatnonzero(depth.max(axis=1, initial=-np.inf) > near)
    seen, depth = seen[number], depth[number]
    if not len(seen):
        return None
    # Cut off what lies behind the viewer.
    gap = depth[:, 1] - depth[:, 0]
    gap = np.where(gap == 0, 1.0, gap)
    cut = (near - depth[:, 0]) / gap
    first = np.where(depth[:, 0] < near, cut, 0.0)
    last = np.where(depth[:, 1] < near, cut, 1.0)
    way = seen[:, 1] - seen[:, 0]
    begin, end = seen[:, 0] + way * first[:, None], seen[:, 0] + way * last[:, None]
    (x0, y0), (x1, y1) = picture.project(begin), picture.project(end)
    low, high = _on_screen(picture, x0, y0, x1, y1)
    keep = high > low
    if not keep.any():
        return None
    x0, y0, x1, y1, low, high, number = (each[keep] for each in (x0, y0, x1, y1, low, high, number))
    return OnScreen((x0, x1), (y0, y1), (begin[keep, 2], end[keep, 2]), low, high, number)


def _paint(picture: RenderedPicture, seen: Array, colours: Array) -> None:
    found = on_screen(picture, seen)
    if found is None:
        return
    (x0, x1), (y0, y1), low, high = found.x, found.y, found.low, found.high
    colours = colours[found.number]
    dx, dy = x1 - x0, y1 - y0
    steps = np.maximum(np.abs(dx), np.abs(dy)) * (high - low)
    counts = np.minimum(np.ceil(steps).astype(int) + 1, 4096)
    if counts.sum() > MOST_SAMPLES:
        room = np.cumsum(counts) <= MOST_SAMPLES
        counts = np.where(room, counts, 0)
    which, number = numbered(counts)
    if not len(which):
        return
    t = low[which] + (high - low)[which] * (number + 0.5) / counts[which]
    x, y = (x0[which] + dx[which] * t).astype(int), (y0[which] + dy[which] * t).astype(int)
    z = found.depth(picture, which, t)
    inside = (x >= 0) & (x < picture.width) & (y >= 0) & (y < picture.height)
    flat = (y * picture.width + x)[inside]
    z, which, t = z[inside], which[inside], t[inside]
    colour = colours[which, 0] + (colours[which, 1] - colours[which, 0]) * t[:, None]
    _write(picture, flat, z, colour, direction(dx, dy)[which], BIAS)


def numbered(counts: Array) -> tuple[Array, Array]:
    """For groups of so many samples: the group of every sample, and its number in it."""
    which = np.repeat(np.arange(len(counts)), counts)
    return which, np.arange(len(which)) - np.repeat(np.cumsum(counts) - counts, counts)


def _on_screen(picture: Projection, x0: Array, y0: Array, x1: Array, y1: Array) -> tuple[Array, Array]:
    """The parts of segments inside the picture, as numbers from 0 to 1 (Liang and Barsky)."""
    low, high = np.zeros(len(x0)), np.ones(len(x0))
    for a, b, size in ((x0, x1, picture.width), (y0, y1, picture.height)):
        step = b - a
        with np.errstate(divide="ignore", invalid="ignore"):
            one, two = -a / step, (size - a) / step
        still = step == 0
        outside = still & ((a < 0) | (a >= size))
        enter = np.where(still, np.where(outside, 2.0, 0.0), np.minimum(one, two))
        leave = np.where(still, np.where(outside, -1.0, 1.0), np.maximum(one, two))
        low, high = np.maximum(low, enter), np.minimum(high, leave)
    return low, high


def direction(dx: Array, dy: Array) -> Array:
    """The kinds of pixels of lines that go this way."""
    flat, upright = np.abs(dy) < 0.4 * np.abs(dx), np.abs(dx) < 0.4 * np.abs(dy)
    rising = dx * dy < 0
    result: Array = np.where(flat, LINE, np.where(upright, LINE + 1, np.where(rising, LINE + 2, LINE + 3)))
    return result


def _write(picture: RenderedPicture, flat: Array, z: Array, colour: Array, kind: Any, bias: float) -> None:
    """Put samples that are in front into the picture, the nearest of every pixel last."""
    buffer = picture.depth.reshape(-1)
    seen = (z * (1 - bias) <= buffer[flat]) & (z > picture.near)
    flat, z, colour = flat[seen], z[seen], colour[seen]
    kind = kind[seen] if np.ndim(kind) else kind
    if not len(flat):
        return
    order = np.argsort(-z, kind="stable")
    # Of a pixel's samples only the nearest counts.
    last = np.full(picture.width * picture.height, -1, np.int64)
    last[flat[order]] = order
    chosen = last[last >= 0]
    tints = colour[chosen]
    kinds = kind[chosen] if np.ndim(kind) else kind
    picture.put(flat[chosen], z[chosen] * (1 - bias), tints[:, :3], tints[:, 3], kinds, tints[:, :3].max(axis=1))


def paint_points(picture: RenderedPicture, points: Points) -> None:
    """Points as squares, as large as they are at their distance."""
    xyz = np.asarray(points.xyz, np.float64).reshape(-1, 3)
    if not len(xyz):
        return
    good = np.isfinite(xyz).all(axis=1)
    turn = np.array(matrix(points.pose.rotation))
    seen = picture.seen(xyz[good] @ turn.T + np.array(points.pose.xyz))
    colours = np.asarray(points.colours, np.float32).reshape(-1, 4)
    colours = colours[good] if len(colours) == len(xyz) else np.broadcast_to(colours[0], (len(seen), 4))
    front = seen[:, 2] > picture.near
    seen, colours = seen[front], colours[front]
    if not len(seen):
        return
    x, y = picture.project(seen)
    tall = points.size * (picture.down if picture.parallel else picture.down / float(np.median(seen[:, 2])))
    side = max(1, min(WIDEST_POINT, round(tall)))
    columns = max(1, round(side * picture.across / picture.down))
    flats, depths, tints = [], [], []
    for right in range(columns):
        for low in range(side):
            px = np.floor(x + right - (columns - 1) / 2).astype(int)
            py = np.floor(y + low - (side - 1) / 2).astype(int)
            inside = (px >= 0) & (px < picture.width) & (py >= 0) & (py < picture.height)
            flats.append((py * picture.width + px)[inside])
            depths.append(seen[inside, 2])
            tints.append(colours[inside])
    _write(picture, np.concatenate(flats), np.concatenate(depths), np.concatenate(tints), SURFACE, 2 * BIAS)
