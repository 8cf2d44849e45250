"""Boxes, cylinders, spheres and cones by casting rays at them inside the rectangle each of them covers.

Every solid is a unit shape in [-1, 1]³ under an affine map, so one set of formulas serves all sizes and ellipsoids too.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
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
    if not (solids := _measure(picture, shapes)):
        return
    opaque = [solid for solid in solids if solid.shape.colour[3] >= 0.997]
    faint = sorted((solid for solid in solids if solid.shape.colour[3] < 0.997), key=lambda solid: -solid.depth)
    with np.errstate(divide="ignore", invalid="ignore", over="ignore"):
        for solid in (*opaque, *faint):
            if solid.is_thin:
                thin.add(solid.centre - solid.half, solid.centre + solid.half, solid.shape.colour)
            else:
                _paint(picture, solid, levels)


class _Solid(NamedTuple):
    """A possibly visible shape: where it is, and what of the camera is where for the unit shape."""

    shape: Shape
    centre: Array
    half: Array
    """Half of its longest extent, as a vector."""
    start: Array
    axes: Array
    """Where the camera is and how its axes lie (3 x 3) for the unit shape."""
    light: Array
    """Where the light comes from, for normals of the unit shape."""
    stretch: Array
    """The squares by which the shape's axes make such normals longer; they stay at right angles."""
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
        starts = (backs @ (picture.position - centres)[:, :, None])[..., 0]
        axes, lights = picture.axes @ backs.transpose(0, 2, 1), backs @ light_of(picture)
        stretches = (backs * backs).sum(axis=2)
    flat = ~np.isfinite(backs).all(axis=(1, 2))
    return [
        _Solid(
            shapes[index],
            centres[index],
            maps[index, :, longest[index]],
            starts[index],
            axes[index],
            lights[index],
            stretches[index],
            float(depths[index]),
            (int(left[index]), int(top[index]), int(right[index]), int(bottom[index])),
            bool(thin[index]),
        )
        for index in np.flatnonzero(seen & (thin | ~flat)).tolist()
    ]


def _paint(picture: RenderedPicture, solid: _Solid, levels: int) -> None:
    shape, (left, top, right, bottom) = solid.shape, solid.region
    start, along = picture.rays_at(solid.region, solid.start, solid.axes)
    depth, normal_at = _HITS.get(shape.kind, _hit_sphere)(start, along, picture.near)
    (hit,) = (depth < picture.depth[top:bottom, left:right]).reshape(-1).nonzero()
    if not len(hit):
        return
    depth = depth.reshape(-1)[hit]
    where = _of(start, hit) + _of(along, hit) * depth
    shade = _shade(normal_at(hit, where), solid, levels) if shape.lit else np.ones(len(hit), np.float32)
    colour = np.array([shape.colour[:3]], np.float32)
    if shape.marked:
        colour, shade = _with_marks(colour, shade, where)
    rows, columns = np.divmod(hit, right - left)
    flat = (rows + top) * picture.width + columns + left
    picture.put(flat, depth, colour * shade[:, None], shape.colour[3], SURFACE, shade)
    if shape.name:
        picture.robot.reshape(-1)[flat] = True


def _of(rays: Array, hit: Array) -> Array:
    """What belongs to the pixels with these flat numbers, 3 x N, or 3 x 1 where it is the same of all."""
    flat: Array = rays.reshape(3, -1)
    return flat if flat.shape[1] == 1 else flat[:, hit]


def _shade(normal: Array, solid: _Solid, levels: int) -> Array:
    """The brightness of places with these normals (3 x N) of the unit shape."""
    length = np.sqrt(solid.stretch @ (normal * normal))
    cosine = np.abs(solid.light @ normal) / np.maximum(length, 1e-30)
    shade = AMBIENT + DIFFUSE * np.fmax(cosine, 0.0)
    result: Array = np.minimum(np.round(shade * levels) / levels, 1.0).astype(np.float32)
    return result


def _with_marks(colour: Array, shade: Array, where: Array) -> tuple[Array, Array]:
    angle = np.arctan2(where[1], where[0]) / (2 * np.pi) % 1.0
    white = _MARKS[(angle * SECTORS).astype(int) % SECTORS]
    return colour + (0.85 - colour) * white[:, None], np.minimum(1.0, shade * (0.75 + 0.25 * white)).astype(np.float32)


_Normals = Callable[[Array, Array], Array]
"""The normals (3 x N) of the unit shape at the pixels with these flat numbers, whose rays hit it in these points (3 x N)."""


def _nearest(enter: Array, leave: Array, near: float) -> Array:
    """Where rays are first in a solid, or where they leave it if they begin in it; infinite where they miss it."""
    depth = np.where(enter > near, enter, leave)
    return np.where((enter <= leave) & (depth > near), depth, np.inf)


def _hit_box(start: Array, along: Array, near: float) -> tuple[Array, _Normals]:
    one, two = (-1 - start) / along, (1 - start) / along
    enter, leave = np.fmin(one, two), np.fmax(one, two)
    depth = _nearest(enter.max(axis=0), leave.min(axis=0), near)

    def normals(hit: Array, where: Array) -> Array:
        sides: Array = (enter == depth) | (leave == depth)
        return sides.reshape(3, -1)[:, hit].astype(np.float64)

    return depth, normals


def _hit_sphere(start: Array, along: Array, near: float) -> tuple[Array, _Normals]:
    a, b, c = (along * along).sum(axis=0), (start * along).sum(axis=0), (start * start).sum(axis=0) - 1
    root = np.sqrt(b * b - a * c)
    depth = _nearest((-b - root) / a, (-b + root) / a, near)
    return depth, lambda hit, where: where


def _hit_cylinder(start: Array, along: Array, near: float) -> tuple[Array, _Normals]:
    (x, y, z), (dx, dy, dz) = start, along
    a, b, c = dx * dx + dy * dy, x * dx + y * dy, x * x + y * y - 1
    root = np.sqrt(b * b - a * c)
    one, two = (-1 - z) / dz, (1 - z) / dz
    above, below = np.fmin(one, two), np.fmax(one, two)
    # A ray along the axis meets no side: it is inside all the way, or nowhere.
    inside = (a == 0) & (c <= 0)
    enter = np.maximum(np.where(inside, -np.inf, (-b - root) / a), above)
    leave = np.minimum(np.where(inside, np.inf, (-b + root) / a), below)
    depth = _nearest(enter, leave, near)

    def normals(hit: Array, where: Array) -> Array:
        on_end = ((above == depth) | (below == depth)).reshape(-1)[hit]
        return np.where(on_end, _UPRIGHT, where * _LEVEL)

    return depth, normals


def _hit_cone(start: Array, along: Array, near: float) -> tuple[Array, _Normals]:
    # x² + y² = ((1 - z) / 2)²: the tip at z = 1, the base of radius 1 at z = -1.
    (x, y, z), (dx, dy, dz) = start, along
    k, m = (1 - z) / 2, -dz / 2
    a, b, c = dx * dx + dy * dy - m * m, x * dx + y * dy - k * m, x * x + y * y - k * k
    root = np.sqrt(b * b - a * c)
    depth = base = (-1 - z) / dz
    across, up = x + dx * base, y + dy * base
    depth = np.where((across * across + up * up <= 1) & (base > near), base, np.inf)
    for t in ((-b - root) / a, (-b + root) / a):
        depth = np.where((np.abs(z + dz * t) <= 1) & (t > near) & (t < depth), t, depth)

    def normals(hit: Array, where: Array) -> Array:
        on_base = (base == depth).reshape(-1)[hit]
        return np.where(on_base, _UPRIGHT, np.stack([where[0], where[1], (1 - where[2]) / 4]))

    return depth, normals


_UPRIGHT, _LEVEL = np.array([[0.0], [0.0], [1.0]]), np.array([[1.0], [1.0], [0.0]])

_HITS = {BOX: _hit_box, CYLINDER: _hit_cylinder, CONE: _hit_cone}
