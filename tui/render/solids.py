"""Boxes, cylinders, spheres and cones by casting rays at them inside the rectangle each of them covers.

Every solid is a unit shape in [-1, 1]³ under an affine map, so one set of formulas serves all sizes and ellipsoids too.
"""

from __future__ import annotations

import math
from collections.abc import Sequence

import numpy as np

from day6_tui.core.ros.programs.rviz2.model.scene import BOX, CONE, CYLINDER, Shape
from day6_tui.core.ros.programs.rviz2.model.turning import matrix
from day6_tui.tui.render.lines import Segments
from day6_tui.tui.render.picture import SURFACE, Array, Picture

AMBIENT, DIFFUSE = 0.45, 0.6

THIN = 1.3
"""Solids that are not thicker than so many pixels are drawn as lines: rays would miss them here and there."""

_CORNERS = np.array([(x, y, z) for x in (-1, 1) for y in (-1, 1) for z in (-1, 1)], np.float64)

SECTORS = 8
_MARKS = np.array([1.0, *((0.0, 0.55) * 4)[:7]], np.float32)
"""How far each sector of a wheel is whitened; the first one tells where the wheel stands."""


def light_of(picture: Picture) -> Array:
    """Where the light comes from: the viewer, a little from the left and above, so that edges show."""
    right, up, forward = picture.axes
    light = -forward - 0.45 * right + 0.35 * up
    result: Array = light / math.sqrt(float(light @ light))
    return result


def paint_solids(picture: Picture, shapes: Sequence[Shape], levels: int, thin: Segments) -> None:
    """Paint opaque solids, then the transparent ones from far to near; thin ones are added to `thin`."""
    light = light_of(picture)
    transparent = []
    for shape in shapes:
        if shape.colour[3] <= 0.003 or not all(math.isfinite(each) for each in (*shape.size, *shape.pose.xyz)):
            continue
        turn = np.array(matrix(shape.pose.rotation))
        solid = turn * (np.array(shape.size, np.float64) / 2)
        centre = np.array(shape.pose.xyz, np.float64)
        if shape.colour[3] < 0.997:
            depth = float((centre - picture.position) @ picture.axes[2])
            transparent.append((depth, shape, solid, centre))
        else:
            _paint(picture, shape, solid, centre, light, levels, thin)
    for _, shape, solid, centre in sorted(transparent, key=lambda each: -each[0]):
        _paint(picture, shape, solid, centre, light, levels, thin)


def _paint(
    picture: Picture, shape: Shape, solid: Array, centre: Array, light: Array, levels: int, thin: Segments
) -> None:
    corners = picture.seen(_CORNERS @ solid.T + centre)
    nearest, farthest = corners[:, 2].min(), corners[:, 2].max()
    if farthest <= picture.near:
        return
    if nearest <= picture.near and not picture.parallel:
        left, top, right, bottom = 0, 0, picture.width, picture.height
    else:
        x, y = picture.project(corners)
        left, right = max(0, int(np.floor(x.min()))), min(picture.width, int(np.ceil(x.max())) + 1)
        top, bottom = max(0, int(np.floor(y.min()))), min(picture.height, int(np.ceil(y.max())) + 1)
        if left >= right or top >= bottom:
            return
        if _as_line(picture, shape, solid, centre, thin):
            return
    try:
        back = np.linalg.inv(solid)
    except np.linalg.LinAlgError:
        return
    start, along = picture.rays(left, top, right, bottom)
    start, along = (start - centre) @ back.T, along @ back.T
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


def _as_line(picture: Picture, shape: Shape, solid: Array, centre: Array, thin: Segments) -> bool:
    """Hand a solid that is thin on the screen to the line painter; True if it was."""
    depth = float((centre - picture.position) @ picture.axes[2])
    scale = picture.pixels_per_metre(depth)
    sizes = [abs(size) * scale for size in shape.size]
    longest = max(range(3), key=sizes.__getitem__)
    others = [size for index, size in enumerate(sizes) if index != longest]
    if max(others) > THIN:
        return False
    half = solid[:, longest]
    thin.add(centre - half, centre + half, shape.colour)
    return True


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
