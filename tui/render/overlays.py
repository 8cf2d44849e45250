"""Pictures over the view: camera images, stacked in its lower right corner."""

from __future__ import annotations

import numpy as np

from day6_tui.core.ros.programs.rviz2.model.scene import Overlay, Scene
from day6_tui.tui.render.picture import SURFACE, Array, Picture

SHARE = 0.45
"""Of the view's width and height that one picture may take."""
NEAREST = 1e-3
LABEL = (230, 230, 230)


def paint_overlays(picture: Picture, scene: Scene) -> None:
    """Put the scene's overlays on a picture, above everything that has been painted."""
    bottom = picture.height
    for overlay in scene.overlays:
        bottom = _paint(picture, overlay, bottom)


def _paint(picture: Picture, overlay: Overlay, bottom: int) -> int:
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
    shrunk = _resized(overlay.pixels, down, across) / 255
    y, x = np.mgrid[top:bottom, left : picture.width]
    flat = (y * picture.width + x).reshape(-1)
    colours = shrunk.reshape(-1, 3)
    picture.put(flat, np.float32(NEAREST), colours, 1.0, SURFACE, colours.mean(axis=1))
    picture.labels = [each for each in picture.labels if not (each[0] >= left - 1 and top <= each[1] < bottom)]
    picture.labels.append((left + across / 2, float(top), overlay.name, LABEL))
    return top


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
