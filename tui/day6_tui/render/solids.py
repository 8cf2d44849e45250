"""Boxes, cylinders, spheres and cones by casting rays at them inside the rectangle each of them covers.

Every solid is a unit shape in [-1, 1]³ under an affine map, so one set of formulas serves all sizes and ellipsoids too.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from typing import NamedTuple

import numpy as np

from day6_core.ros.programs.rviz2.model.scene import BOX, CONE, CYLINDER, Shape
from day6_core.ros.programs.rviz2.model.turning import matrix
from day6_tui.render.lines import Segments
from day6_tui.render.picture import SURFACE, Array, RenderedPicture

AMBIENT, DIFFUSE = 0.45, 0.6

THIN = 1.3
"""Solids at most this many pixels thick are drawn as lines: rays would miss parts of them."""

_CORNERS = np.array([(x, y, z) for x in (-1, 1) for y in (-1, 1) for z in (-1, 1)], np.float64)

SECTORS = 8
_MARKS = np.array([1.0, *((0.0, 0.55) * 4)[:7]], np.float32)
"""How much each sector of a wheel is whitened; the first one shows the wheel's angle."""


def light_of(picture: RenderedPicture) -> Array:
    """Where the light comes from: the viewer, a little from the left and above, so that edges show."""
    right, up, forward = picture.axes
    light = -forward - 0.45 * right + 0.35 * up
    result: Array = light / math.sqrt(float(light @ light))
    return result


def paint_solids(picture: RenderedPicture, shapes: Sequence[Shape], levels: int, thin: Segments) -> None:
    """Paint opaque solids, then the transparent ones from far to near; thin ones are added to `thin`."""
    solids = _measure(picture, shapes)
    light = light_of(picture)
    opaque = [solid for solid in solids if solid.shape.colour[3] >= 0.997]
    faint = sorted((solid for solid in solids if solid.shape.colour[3] < 0.997), key=lambda solid: -solid.depth)
    for solid in (*opaque, *faint):
        if solid.is_thin:
            thin.add(solid.centre - solid.half, solid.centre + solid.half, solid.shape.colour)
        else:
            _paint(picture, solid, light, levels)


class _Solid(NamedTuple):
    """A possibly visible shape: its pose, the pixels it covers at most, the map back to the unit shape."""

    shape: Shape
    centre: Array
    half: Array
    """Half of its longest extent, as a vector."""
    back: Array
    depth: float
    region: tuple[int, int, int, int]
    """Left, top, right and bottom."""
    is_thin: bool


def _measure(picture: RenderedPicture, shapes: Sequence[Shape]) -> list[_Solid]:
    """Compute for all shapes at once where they are on the screen and how large."""
    shapes = [
        shape
        for shape in shapes
        if shape.colour[3] > 0.003 and all(map(math.isfinite, (*shape.size, *shape.pose.xyz, *shape.pose.rotation)))
    ]
    if not shapes:
        return []
    turns = np.array([matrix(shape.pose.rotation) for shape in shapes])
    sizes = np.array([shape.size for shape in shapes], np.float64)
    centres = np.array([shape.pose.xyz for shape in shapes], np.float64)
    maps = turns * (sizes[:, None, :] / 2)
    corners = picture.seen(_CORNERS @ maps.transpose(0, 2, 1) + centres[:, None, :])
    nearest, farthest = corners[..., 2].min(axis=1), corners[..., 2].max(axis=1)
    x, y = picture.project(corners)
    width, height = picture.width, picture.height
    left, right = np.floor(np.clip(x.min(axis=1), 0, width)), np.ceil(np.clip(x.max(axis=1) + 1, 0, width))
    top, bottom = np.floor(np.clip(y.min(axis=1), 0, height)), np.ceil(np.clip(y.max(axis=1) + 1, 0, height))
    whole = (nearest <= picture.near) & (not picture.parallel)
    left, top = np.where(whole, 0, left).astype(int), np.where(whole, 0, top).astype(int)
    right, bottom = np.where(whole, width, right).astype(int), np.where(whole, height, bottom).astype(int)
    seen = (farthest > picture.near) & (left < right) & (top < bottom)
    depths = (centres - picture.position) @ picture.axes[2]
    scale = picture.down / (1.0 if picture.parallel else np.maximum(depths, picture.near))
    second = np.sort(np.abs(sizes), axis=1)[:, 1]
    thin = (second * scale <= THIN) & ~whole
    longest = np.abs(sizes).argmax(axis=1)
    with np.errstate(divide="ignore", invalid="ignore", over="ignore"):
        # The inverse of a rotation after a scaling.
        backs = 2 / sizes[:, :, None] * turns.transpose(0, 2, 1)
    flat = ~np.isfinite(backs).all(axis=(1, 2))
    return [
        _Solid(
            shapes[index],
            centres[index],
            maps[index, :, longest[index]],
            backs[index],
            float(depths[index]),
            (int(left[index]), int(top[index]), int(right[index]), int(bottom[index])),
            bool(thin[index]),
        )
        for index in np.flatnonzero(seen & (thin | ~flat)).tolist()
    ]


def _paint(picture: RenderedPicture, solid: _Solid, light: Array, levels: int) -> None:
    shape, back = solid.shape, solid.back
    left, top, right, bottom = solid.region
    start, along = picture.rays(left, top, right, bottom)
    start, along = (start - solid.centre) @ back.T, along @ back.T
    with np.errstate(divide="ignore", invalid="ignore", over="ignore"):
        depth, normal, where = _HITS.get(shape.kind, _hit_sphere)(start, along, picture.near)
        region = np.s_[top:bottom, left:right]
        hit = depth < picture.depth[region]
        if not hit.any():
            return
        depth, normal = depth[hit], normal[hit] @ back
        shade = _shade(normal, light, levels) if shape.lit else np.ones(len(depth), np.float32)
        colour = np.array(shape.colour[:3], np.float32)[None, :] * np.ones((len(depth), 1), np.float32)
        if shape.marked:
            colour, shade = _with_marks(colour, shade, where[hit])
    rows, columns = np.nonzero(hit)
    flat = (rows + top) * picture.width + columns + left
    picture.put(flat, depth, colour * shade[:, None], shape.colour[3], SURFACE, shade)
    if shape.name:
        picture.robot.reshape(-1)[flat] = True


def _shade(normal: Array, light: Array, levels: int) -> Array:
    length = np.sqrt((normal * normal).sum(axis=1))
    cosine = np.abs(normal @ light) / np.maximum(length, 1e-30)
    shade = AMBIENT + DIFFUSE * np.nan_to_num(cosine)
    result: Array = np.minimum(np.round(shade * levels) / levels, 1.0).astype(np.float32)
    return result


def _with_marks(colour: Array, shade: Array, where: Array) -> tuple[Array, Array]:
    angle = np.arctan2(where[:, 1], where[:, 0]) / (2 * np.pi) % 1.0
    white = _MARKS[(angle * SECTORS).astype(int) % SECTORS]
    return colour + (0.85 - colour) * white[:, None], np.minimum(1.0, shade * (0.75 + 0.25 * white)).astype(np.float32)


def _nearest(
    candidates: list[tuple[Array, Array]], start: Array, along: Array, near: float
) -> tuple[Array, Array, Array]:
    """The first of several hits (parameter, normal), each of which is infinite where there is none."""
    depth, normal = candidates[0]
    depth = np.where(depth > near, depth, np.inf)
    normal = np.broadcast_to(normal, start.shape)
    for other, its_normal in candidates[1:]:
        closer = (other < depth) & (other > near)
        depth = np.where(closer, other, depth)
        normal = np.where(closer[..., None], its_normal, normal)
    finite = np.where(np.isfinite(depth), depth, 0.0)
    return depth, normal, start + along * finite[..., None]


def _hit_box(start: Array, along: Array, near: float) -> tuple[Array, Array, Array]:
    one, two = (-1 - start) / along, (1 - start) / along
    enter, leave = np.fmin(one, two), np.fmax(one, two)
    first, last = enter.max(axis=-1), leave.min(axis=-1)
    inside = first <= near
    depth = np.where(inside, last, first)
    depth = np.where((last >= first) & (depth > near), depth, np.inf)
    face = np.where(inside[..., None], leave <= last[..., None], enter >= first[..., None])
    finite = np.where(np.isfinite(depth), depth, 0.0)
    return depth, face.astype(np.float64), start + along * finite[..., None]


def _hit_sphere(start: Array, along: Array, near: float) -> tuple[Array, Array, Array]:
    a = (along * along).sum(axis=-1)
    b = (start * along).sum(axis=-1)
    c = (start * start).sum(axis=-1) - 1
    root = np.sqrt(b * b - a * c)
    one, two = (-b - root) / a, (-b + root) / a
    depth = np.where(one > near, one, two)
    depth = np.where(np.isfinite(depth) & (depth > near), depth, np.inf)
    where = start + along * np.where(np.isfinite(depth), depth, 0.0)[..., None]
    return depth, where, where


def _hit_cylinder(start: Array, along: Array, near: float) -> tuple[Array, Array, Array]:
    a = (along[..., :2] ** 2).sum(axis=-1)
    b = (start[..., :2] * along[..., :2]).sum(axis=-1)
    c = (start[..., :2] ** 2).sum(axis=-1) - 1
    root = np.sqrt(b * b - a * c)
    found: list[tuple[Array, Array]] = []
    for t in ((-b - root) / a, (-b + root) / a):
        point = start + along * t[..., None]
        side = np.where(np.abs(point[..., 2]) <= 1, t, np.inf)
        found.append((np.nan_to_num(side, nan=np.inf), point * (1.0, 1.0, 0.0)))
    for end in (-1.0, 1.0):
        found.append((_disc(start, along, end, 1.0), np.array([0.0, 0.0, end])))
    return _nearest(found, start, along, near)


def _hit_cone(start: Array, along: Array, near: float) -> tuple[Array, Array, Array]:
    # x² + y² = ((1 - z) / 2)²: the tip at z = 1, the base of radius 1 at z = -1.
    k = (1 - start[..., 2]) / 2
    m = -along[..., 2] / 2
    a = (along[..., :2] ** 2).sum(axis=-1) - m * m
    b = (start[..., :2] * along[..., :2]).sum(axis=-1) - k * m
    c = (start[..., :2] ** 2).sum(axis=-1) - k * k
    root = np.sqrt(b * b - a * c)
    found: list[tuple[Array, Array]] = []
    for t in ((-b - root) / a, (-b + root) / a):
        point = start + along * t[..., None]
        side = np.where(np.abs(point[..., 2]) <= 1, t, np.inf)
        normal = point.copy()
        normal[..., 2] = (1 - point[..., 2]) / 4
        found.append((np.nan_to_num(side, nan=np.inf), normal))
    found.append((_disc(start, along, -1.0, 1.0), np.array([0.0, 0.0, -1.0])))
    return _nearest(found, start, along, near)


def _disc(start: Array, along: Array, height: float, radius: float) -> Array:
    t = (height - start[..., 2]) / along[..., 2]
    x, y = start[..., 0] + along[..., 0] * t, start[..., 1] + along[..., 1] * t
    result: Array = np.nan_to_num(np.where(x * x + y * y <= radius * radius, t, np.inf), nan=np.inf)
    return result


_HITS = {BOX: _hit_box, CYLINDER: _hit_cylinder, CONE: _hit_cone}
