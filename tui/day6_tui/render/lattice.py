"""Grids: lines that fade out before they come closer to their neighbours than pixels can tell apart."""

from __future__ import annotations

from functools import lru_cache
from typing import Any, NamedTuple

import numpy as np

from day6_core.ros.programs.rviz2.model.scene import Lines
from day6_tui.render.lines import BIAS, direction, ends_of, numbered, on_screen
from day6_tui.render.picture import EMPTY, Array, Projection, RenderedPicture

TOO_CLOSE, FAR_ENOUGH = 4.0, 8.0
"""Pixels between neighbours: at the first a line is gone, at the second it is there in full."""

STEPS = (1, 2, 5, 10, 20, 50, 100)
"""Where every line would be too close, every second one stays, then every fifth, and so on."""

SHADES = 4
"""Degrees in which a pixel may be covered: few, so that a picture has few colours."""


class _Samples(NamedTuple):
    """What a grid covers, pixel by pixel: samples of its lines, in the order of their pixels."""

    pixels: Array
    """The flat numbers of the pixels that have any."""
    first: Array
    """Where those of each pixel begin."""
    which: Array
    """For each sample, which of the pixels it is in."""
    cover: Array
    depth: Array
    kind: Array
    """EMPTY beside the line."""


def paint_lattice(picture: RenderedPicture, lines: Lines) -> None:
    """Paint a grid; every line covers the two pixels beside it in shares, so that slanted lines are smooth."""
    samples = _samples(lines, *picture.projection)
    if samples is None:
        return
    pixels, first, which, cover, depth, kind = samples
    seen = depth <= picture.depth.reshape(-1)[pixels][which]
    shades = np.round(np.maximum.reduceat(np.where(seen, cover, 0.0), first) * SHADES) / SHADES
    # The far end of what a pixel shows of a line: a point that lies in the plane of the grid, there, is not behind it.
    farthest = np.maximum.reduceat(np.where(seen, depth, 0.0), first)
    kinds = picture.kind.reshape(-1)[pixels]
    on = seen & (kind != EMPTY)
    kinds[which[on]] = kind[on]
    shown = np.flatnonzero(shades)
    red, green, blue, alpha = lines.colours[0]
    alphas = (alpha * shades[shown]).astype(np.float32)
    colour = np.broadcast_to(np.array([red, green, blue], np.float32), (len(shown), 3))
    picture.put(pixels[shown], farthest[shown], colour, alphas, kinds[shown], max(red, green, blue))


@lru_cache(maxsize=4)
def _samples(lines: Lines, *projection: Any) -> _Samples | None:
    """Sample a grid as it is seen from one place, from where it is painted again and again."""
    picture = Projection(*projection)
    seen = picture.seen(ends_of(lines).reshape(-1, 3)).reshape(-1, 2, 3)
    found = on_screen(picture, seen) if np.isfinite(seen).all() else None
    if found is None or len(seen) < 4:
        return None
    (x0, x1), (y0, y1) = found.x, found.y
    dx, dy = x1 - x0, y1 - y0
    flat = np.abs(dx) >= np.abs(dy)
    # One sample for every pixel of the longer way.
    start, way = np.where(flat, x0, y0), np.where(flat, dx, dy)
    way = np.where(way == 0, 1e-9, way)
    one, other = start + way * found.low, start + way * found.high
    first = np.floor(np.minimum(one, other)).astype(int)
    which, number = numbered(np.floor(np.maximum(one, other)).astype(int) - first + 1)
    along = first[which] + number
    t = np.clip((along + 0.5 - start[which]) / way[which], found.low[which], found.high[which])
    z = found.depth(picture, which, t)
    x, y = x0[which] + dx[which] * t, y0[which] + dy[which] * t
    strength = _strength(picture, seen, found.number[which], (x, y, z), (dx[which], dy[which]))
    across = np.where(flat[which], y, x) - 0.5
    before = np.floor(across).astype(int)
    share = across - before
    kinds = direction(dx, dy)[which]
    places, covers, on = [], [], []
    for side, part, nearer in ((before, 1 - share, share < 0.5), (before + 1, share, share >= 0.5)):
        column, row = np.where(flat[which], along, side), np.where(flat[which], side, along)
        inside = (column >= 0) & (column < picture.width) & (row >= 0) & (row < picture.height)
        places.append(np.where(inside, row * picture.width + column, -1))
        covers.append(part * strength)
        # For characters without shades a pixel is on the line or not.
        on.append(np.where(nearer & (strength >= 0.5), kinds, EMPTY))
    place, cover, depth, kind = np.concatenate(places), np.concatenate(covers), np.tile(z, 2), np.concatenate(on)
    order = np.argsort(place, kind="stable")
    order = order[(place >= 0)[order] & (cover > 0)[order] & (depth > picture.near)[order]]
    if not len(order):
        return None
    pixels, begins, which = np.unique(place[order], return_index=True, return_inverse=True)
    return _Samples(pixels, begins, which, cover[order], depth[order] * (1 - BIAS), kind[order])


def _strength(
    picture: Projection, seen: Array, number: Array, place: tuple[Array, Array, Array], way: tuple[Array, Array]
) -> Array:
    """How much of a line is left at its samples: by the distance to its neighbour there, in pixels."""
    x, y, z = place
    scale = 1.0 if picture.parallel else z
    right, up = (x - picture.width / 2) / picture.across * scale, (picture.height / 2 - y) / picture.down * scale
    # The two directions take turns, so the neighbour is the segment after the next.
    step = np.stack([seen[2, 0] - seen[0, 0], seen[3, 0] - seen[1, 0]])[number % 2]
    beside = np.stack([right, up, z], axis=1) + step
    bx, by = picture.project(beside)
    dx, dy = way
    length = np.maximum(np.hypot(dx, dy), 1e-9)
    apart = np.where(beside[:, 2] > picture.near, np.abs((bx - x) * dy - (by - y) * dx) / length, np.inf)
    rank, last = number // 2, len(seen) // 2 - 1
    worth = np.max([np.where(rank % each == 0, each, 1) for each in STEPS], axis=0)
    worth = np.where((rank == 0) | (rank == last), np.inf, worth)
    strength: Array = np.clip((np.maximum(apart, 1e-9) * worth - TOO_CLOSE) / (FAR_ENOUGH - TOO_CLOSE), 0.0, 1.0)
    return strength
