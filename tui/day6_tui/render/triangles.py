"""Meshes: all triangles at once, by their candidate pixels; no loop over triangles."""

from __future__ import annotations

import math
from collections import OrderedDict
from collections.abc import Sequence

import numpy as np

from day6_core.ros.programs.rviz2.model.scene import Triangles
from day6_core.ros.programs.rviz2.model.turning import matrix
from day6_tui.render.picture import SURFACE, Array, RenderedPicture
from day6_tui.render.solids import AMBIENT, DIFFUSE, light_of

CHUNK = 1_500_000
"""Candidate pixels looked at in one go: bounds the memory."""

_MOST_KEPT = 64
_normals: OrderedDict[int, tuple[Array, Array]] = OrderedDict()
"""Face normals of meshes by the id of their face array; the array is kept too, so that the id is not reused."""


def paint_triangles(picture: RenderedPicture, meshes: Sequence[Triangles], levels: int) -> None:
    """Paint opaque meshes, then the transparent ones from far to near."""
    light = light_of(picture)

    def depth(mesh: Triangles) -> float:
        return float((np.array(mesh.pose.xyz) - picture.position) @ picture.axes[2])

    for mesh in [mesh for mesh in meshes if mesh.colour[3] >= 0.997]:
        _paint(picture, mesh, light, levels)
    for mesh in sorted((mesh for mesh in meshes if 0.003 < mesh.colour[3] < 0.997), key=lambda each: -depth(each)):
        _paint(picture, mesh, light, levels)


def _face_normals(mesh: Triangles) -> Array:
    kept = _normals.get(id(mesh.faces))
    if kept is not None:
        known: Array = kept[1]
        return known
    a, b, c = (np.asarray(mesh.vertices)[np.asarray(mesh.faces)[:, index]] for index in range(3))
    normal = np.cross(b - a, c - a)
    length = np.sqrt((normal * normal).sum(axis=1))
    normal = (normal / np.maximum(length, 1e-30)[:, None]).astype(np.float32)
    _normals[id(mesh.faces)] = (mesh.faces, normal)
    while len(_normals) > _MOST_KEPT:
        _normals.popitem(last=False)
    result: Array = normal
    return result


def _paint(picture: RenderedPicture, mesh: Triangles, light: Array, levels: int) -> None:
    faces = np.asarray(mesh.faces)
    if not len(faces) or not all(map(math.isfinite, mesh.scale)):
        return
    turn = np.array(matrix(mesh.pose.rotation))
    points = (np.asarray(mesh.vertices) * np.array(mesh.scale)) @ turn.T + np.array(mesh.pose.xyz)
    seen = picture.seen(points)
    x, y = picture.project(seen)
    corner_x, corner_y, corner_z = x[faces], y[faces], seen[:, 2][faces]
    left, right = np.floor(corner_x.min(axis=1)), np.floor(corner_x.max(axis=1))
    top, bottom = np.floor(corner_y.min(axis=1)), np.floor(corner_y.max(axis=1))
    visible = corner_z.min(axis=1) > picture.near
    visible &= (right >= 0) & (left < picture.width) & (bottom >= 0) & (top < picture.height)
    which = np.flatnonzero(visible)
    if not len(which):
        return
    corner_x, corner_y, corner_z = corner_x[which], corner_y[which], corner_z[which]
    box = [
        np.clip(edge[which], 0, most).astype(np.int64)
        for edge, most in ((left, picture.width - 1), (right, picture.width - 1), (top, picture.height - 1))
    ]
    box.append(np.clip(bottom[which], 0, picture.height - 1).astype(np.int64))
    columns, rows = box[1] - box[0] + 1, box[3] - box[2] + 1
    if mesh.lit:
        scaled = _face_normals(mesh)[which] / np.maximum(np.abs(np.array(mesh.scale, np.float32)), 1e-12)
        normal = scaled @ turn.T.astype(np.float32)
        length = np.sqrt((normal * normal).sum(axis=1))
        # Both sides are lit: the winding order of a file's triangles is not reliable.
        shade = AMBIENT + DIFFUSE * np.abs(normal @ light.astype(np.float32)) / np.maximum(length, 1e-30)
        shade = np.minimum(np.round(shade * levels) / levels, 1.0).astype(np.float32)
    else:
        shade = np.ones(len(which), np.float32)
    if mesh.colours is not None:
        tint = np.asarray(mesh.colours, np.float32)[which]
    else:
        tint = np.broadcast_to(np.array(mesh.colour[:3], np.float32), (len(which), 3))
    areas = columns * rows
    begin = 0
    sums = np.cumsum(areas)
    while begin < len(which):
        base = int(sums[begin - 1]) if begin else 0
        end = max(begin + 1, int(np.searchsorted(sums, base + CHUNK)))
        part = np.s_[begin:end]
        _fill(
            picture,
            (corner_x[part], corner_y[part], corner_z[part]),
            (box[0][part], box[2][part], columns[part], areas[part]),
            shade[part],
            tint[part],
            mesh.colour[3],
            is_robot=bool(mesh.name),
        )
        begin = end


def _fill(
    picture: RenderedPicture,
    corners: tuple[Array, Array, Array],
    box: tuple[Array, Array, Array, Array],
    shade: Array,
    tint: Array,
    alpha: float,
    *,
    is_robot: bool,
) -> None:
    left, top, columns, areas = box
    which = np.repeat(np.arange(len(areas)), areas)
    number = np.arange(len(which)) - np.repeat(np.cumsum(areas) - areas, areas)
    wide = columns[which]
    px, py = left[which] + number % wide, top[which] + number // wide
    x, y, z = (each[which] for each in corners)
    area = (x[:, 1] - x[:, 0]) * (y[:, 2] - y[:, 0]) - (x[:, 2] - x[:, 0]) * (y[:, 1] - y[:, 0])
    area = np.where(np.abs(area) < 1e-9, 1e-9, area)
    cx, cy = px + 0.5, py + 0.5
    u = ((x[:, 1] - cx) * (y[:, 2] - cy) - (x[:, 2] - cx) * (y[:, 1] - cy)) / area
    v = ((x[:, 2] - cx) * (y[:, 0] - cy) - (x[:, 0] - cx) * (y[:, 2] - cy)) / area
    w = 1 - u - v
    # A triangle smaller than a pixel counts as filling it, else fine meshes would be full of holes.
    inside = ((u >= 0) & (v >= 0) & (w >= 0)) | (areas[which] == 1)
    if not inside.any():
        return
    u, v, w = (np.clip(each[inside], 0, 1) for each in (u, v, w))
    z = z[inside]
    total = np.maximum(u + v + w, 1e-9)
    if picture.parallel:
        depth = ((u * z[:, 0] + v * z[:, 1] + w * z[:, 2]) / total).astype(np.float32)
    else:  # on the screen 1/z is linear
        depth = (total / (u / z[:, 0] + v / z[:, 1] + w / z[:, 2])).astype(np.float32)
    flat = py[inside] * picture.width + px[inside]
    which = which[inside]
    buffer = picture.depth.reshape(-1)
    in_front = depth < buffer[flat]
    flat, depth, which = flat[in_front], depth[in_front], which[in_front]
    nearest = np.full(len(buffer), np.inf, np.float32)
    np.minimum.at(nearest, flat, depth)
    winners = depth <= nearest[flat]
    flat, depth, which = flat[winners], depth[winners], which[winners]
    flat, first = np.unique(flat, return_index=True)
    depth, which = depth[first], which[first]
    light = shade[which]
    picture.put(flat, depth, tint[which] * light[:, None], alpha, SURFACE, light)
    if is_robot:
        picture.robot.reshape(-1)[flat] = True
