"""Pictures over the view: camera images, stacked in its lower right corner."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np

from day6_core.ros.programs.rviz2.model.scene import Overlay, Scene, Sight
from day6_tui.render.picture import EMPTY, SURFACE, Array, PictureText, RenderedPicture

SHARE = 0.45
"""Of the view's width and height that one picture may take."""
NEAREST = 1e-3
LABEL = (230, 230, 230)


PaintScene = Callable[[RenderedPicture, Scene], None]


def paint_overlays(picture: RenderedPicture, scene: Scene, paint: PaintScene) -> None:
    """Put the scene's overlays on a picture, above everything that has been painted; `paint` paints what a camera sees."""
    bottom = picture.height
    for overlay in scene.overlays:
        bottom = _paint(picture, overlay, bottom, paint)


def _paint(picture: RenderedPicture, overlay: Overlay, bottom: int, paint: PaintScene) -> int:
    """Paint one with its lower edge at `bottom`; returns where the next one ends."""
    rows, columns = overlay.pixels.shape[:2]
    # In pixels of the view, which are not square everywhere.
    width = picture.width * SHARE
    height = width * picture.down / picture.across * rows / columns
    most = min(picture.height * SHARE, bottom)
    if height > most:
        width, height = width * most / height, most
    across, down = int(width), int(height)
    if across < 2 or down < 2:
        return bottom
    top, left = bottom - down, picture.width - across
    sight = overlay.sight
    shrunk = (
        _resized(overlay.pixels, down, across) / 255 if sight is None else _seen(overlay, sight, across, down, paint)
    )
    y, x = np.mgrid[top:bottom, left : picture.width]
    flat = (y * picture.width + x).reshape(-1)
    colours = shrunk.reshape(-1, 3)
    picture.put(flat, np.float32(NEAREST), colours, 1.0, SURFACE, colours.mean(axis=1))
    picture.labels = [each for each in picture.labels if not (each.x >= left - 1 and top <= each.y < bottom)]
    picture.labels.append(PictureText(left + across / 2, float(top), overlay.name, LABEL))
    return top


def _seen(overlay: Overlay, sight: Sight, across: int, down: int, paint: PaintScene) -> Array:
    """The picture of a camera with the scene in it, rows x columns x 3 (0..1)."""
    inner = RenderedPicture(across, down, 1.0, sight.camera, sight.scene.background)
    inner.across, inner.down = sight.focal[0] * across, sight.focal[1] * down
    inner.offset = sight.middle[0] * across, sight.middle[1] * down
    photo, covered = _zoomed(overlay.pixels, across, down, sight.zoom)
    if sight.behind:
        inner.colour[covered] = photo[covered]
    ground = inner.colour.copy()
    paint(inner, sight.scene)
    beyond = (inner.depth > sight.far) & (inner.kind != EMPTY)
    inner.colour[beyond] = ground[beyond]
    inner.colour[covered] += (photo[covered] - inner.colour[covered]) * sight.alpha
    return inner.colour


def _zoomed(pixels: Array, across: int, down: int, zoom: float) -> tuple[Array, Array]:
    """The photo in a frame it is `zoom` times as wide and high as, and where in the frame it is."""
    rows, columns = pixels.shape[:2]
    x = ((np.arange(across) + 0.5) / across - 0.5) / zoom + 0.5
    y = ((np.arange(down) + 0.5) / down - 0.5) / zoom + 0.5
    covered: Array = ((y >= 0) & (y < 1))[:, None] & ((x >= 0) & (x < 1))[None, :]
    if zoom == 1:
        return _resized(pixels, down, across) / 255, covered
    nearest = pixels[np.clip(y * rows, 0, rows - 1).astype(int)][:, np.clip(x * columns, 0, columns - 1).astype(int)]
    return nearest.astype(np.float32) / 255, covered


def _resized(pixels: Array, height: int, width: int) -> Array:
    """The mean of what falls into each new pixel, or the nearest pixel where there are fewer."""
    rows, columns = pixels.shape[:2]
    down, across = np.arange(height) * rows // height, np.arange(width) * columns // width
    if rows < height or columns < width:
        nearest: Array = pixels[down][:, across].astype(np.float32)
        return nearest
    sums = np.add.reduceat(np.add.reduceat(pixels.astype(np.float32), down, axis=0), across, axis=1)
    counts = np.diff(down, append=rows)[:, None, None] * np.diff(across, append=columns)[None, :, None]
    result: Array = sums / counts
    return result
