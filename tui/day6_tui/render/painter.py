"""From a scene and a camera to a picture."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from day6_core.ros.programs.rviz2.model.scene import Image, Scene
from day6_core.ros.programs.rviz2.model.turning import matrix
from day6_core.ros.programs.rviz2.model.views import Camera
from day6_tui.render.lattice import paint_lattice
from day6_tui.render.lines import Segments, paint_points
from day6_tui.render.overlays import paint_overlays
from day6_tui.render.picture import SURFACE, Array, PictureText, RenderedPicture
from day6_tui.render.solids import paint_solids
from day6_tui.render.triangles import paint_triangles


@dataclass(frozen=True)
class Quality:
    """The amount of detail: shades of one colour, steps of colours, pixels left out."""

    levels: int
    step: int
    coarse: int


QUALITIES = {"High": Quality(20, 4, 1), "Medium": Quality(8, 8, 1), "Low": Quality(5, 16, 2)}


def paint(
    scene: Scene,
    camera: Camera,
    width: int,
    height: int,
    aspect: float,
    quality: Quality,
    offset: tuple[float, float] = (0.0, 0.0),
    *,
    grids: bool = True,
) -> RenderedPicture:
    """Paint a scene, with its `grids` or without; `aspect` is the width of a pixel by its height, `offset` moves everything by
    parts of a pixel."""
    coarse = quality.coarse
    picture = RenderedPicture(
        max(1, width // coarse), max(1, height // coarse), aspect, camera, scene.background, offset
    )
    _paint_parts(picture, scene, quality.levels, grids=grids)
    paint_overlays(picture, scene, lambda inner, seen: _paint_parts(inner, seen, quality.levels))
    return picture if coarse == 1 else _enlarged(picture, width, height)


def paint_grids(picture: RenderedPicture, scene: Scene, finer: int) -> RenderedPicture:
    """Paint the grids of a scene alone, `finer` times as finely as its picture, which hides what lies behind it."""
    found = RenderedPicture(
        picture.width * finer,
        picture.height * finer,
        picture.down / picture.across,
        picture.camera,
        picture.background,
    )
    found.depth = picture.depth.repeat(finer, axis=0).repeat(finer, axis=1)
    for lines in scene.lines:
        if lines.lattice:
            paint_lattice(found, lines)
    return found


def _paint_parts(picture: RenderedPicture, scene: Scene, levels: int, *, grids: bool = True) -> None:
    """Everything of a scene but what lies on the picture."""
    for image in scene.images:
        if image.behind:
            _paint_image(picture, image)
    thin = Segments()
    paint_solids(picture, [each for each in scene.shapes if each.colour[3] >= 0.997], levels, thin)
    paint_triangles(picture, scene.triangles, levels)
    for image in scene.images:
        if not image.behind:
            _paint_image(picture, image)
    for lines in scene.lines:
        if not lines.lattice:
            thin.extend(lines)
    thin.paint(picture)
    for lines in scene.lines:
        if lines.lattice and grids:
            paint_lattice(picture, lines)
    for points in scene.points:
        paint_points(picture, points)
    faint = Segments()
    paint_solids(picture, [each for each in scene.shapes if each.colour[3] < 0.997], levels, faint)
    faint.paint(picture)
    _place_labels(picture, scene)


def _enlarged(picture: RenderedPicture, width: int, height: int) -> RenderedPicture:
    """Every pixel becomes a block."""
    rows = np.minimum(np.arange(height) * picture.height // max(1, height), picture.height - 1)
    columns = np.minimum(np.arange(width) * picture.width // max(1, width), picture.width - 1)
    for name in ("colour", "depth", "kind", "shade", "robot"):
        setattr(picture, name, getattr(picture, name)[rows][:, columns])
    across, down = width / picture.width, height / picture.height
    picture.labels = [text._replace(x=text.x * across, y=text.y * down) for text in picture.labels]
    picture.width, picture.height = width, height
    return picture


def _place_labels(picture: RenderedPicture, scene: Scene) -> None:
    if not scene.labels:
        return
    seen = picture.seen(np.array([label.position for label in scene.labels], np.float64))
    x, y = picture.project(seen)
    for label, column, row, depth in zip(scene.labels, x, y, seen[:, 2], strict=True):
        if depth > picture.near and 0 <= column < picture.width and 0 <= row < picture.height and label.colour[3] > 0.1:
            red, green, blue = (int(255 * max(0.0, min(1.0, part))) for part in label.colour[:3])
            text = PictureText(float(column), float(row), label.text, (red, green, blue), label.is_name)
            picture.labels.append(text)


def _paint_image(picture: RenderedPicture, image: Image) -> None:
    """A map: every pixel's ray meets the plane of the image somewhere."""
    pixels: Array = np.asarray(image.pixels)
    rows, columns = pixels.shape[:2]
    turn = np.array(matrix(image.pose.rotation))
    start, along = picture.rays(0, 0, picture.width, picture.height)
    start, along = (start - np.array(image.pose.xyz)) @ turn, along @ turn
    with np.errstate(divide="ignore", invalid="ignore", over="ignore"):
        depth = -start[..., 2] / along[..., 2]
        x = np.floor((start[..., 0] + along[..., 0] * depth) / image.resolution)
        y = np.floor((start[..., 1] + along[..., 1] * depth) / image.resolution)
        limit = picture.depth if not image.behind else np.inf
        hit = (depth > picture.near) & (depth < limit) & (x >= 0) & (x < columns) & (y >= 0) & (y < rows)
    if not hit.any():
        return
    colour = pixels[y[hit].astype(int), x[hit].astype(int)].astype(np.float32) / 255
    flat = np.flatnonzero(hit.reshape(-1))
    alpha = colour[:, 3]
    kept = alpha > 0.003
    distance = np.full(int(kept.sum()), 1e8, np.float32) if image.behind else depth[hit][kept]
    picture.put(flat[kept], distance, colour[kept, :3], alpha[kept], SURFACE, colour[kept, :3].mean(axis=1))
