"""The picture being painted: colours, depths and kinds of pixels, and the geometry of the camera's rays."""

from __future__ import annotations

import math
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from day6_core.ros.programs.rviz2.model.views import FIELD_OF_VIEW, Camera

Array = NDArray[Any]

EMPTY, SURFACE = 0, 1
LINE = 2
"""Kinds of pixels; lines have four kinds, by their direction: 2 flat, 3 upright, 4 rising, 5 falling."""

FAR = 1e9


class PictureText(NamedTuple):
    """A text at a pixel."""

    x: float
    y: float
    words: str
    colour: tuple[int, int, int]
    is_name: bool = False
    """Whether it only names what is there, and so should leave a robot to be seen."""


class Projection:
    """The geometry of the camera's rays in `width` x `height` pixels, of which one metre takes `across` x `down`."""

    def __init__(
        self, camera: Camera, width: int, height: int, across: float, down: float, offset: tuple[float, float]
    ) -> None:
        self.camera = camera
        self.width, self.height = width, height
        self.across, self.down = across, down
        """Pixels for one metre (parallel), or for one metre at depth 1."""
        self.offset = offset
        """Parts of a pixel by which the scene is moved to the right and down."""
        self.position: Array = np.array(camera.position, np.float64)
        self.axes: Array = np.array([camera.right, camera.up, camera.forward], np.float64)
        self.parallel = camera.metres is not None
        self.near = max(camera.near, 1e-3)

    @property
    def projection(self) -> tuple[Camera, int, int, float, float, tuple[float, float]]:
        """All that where things are seen depends on."""
        return self.camera, self.width, self.height, self.across, self.down, self.offset

    # -- from the scene to the picture ---------------------------------------------------------------------------------

    def seen(self, points: Array) -> Array:
        """Points (N x 3) in the camera's axes: right, up, depth."""
        result: Array = (points - self.position) @ self.axes.T
        return result

    def project(self, seen: Array) -> tuple[Array, Array]:
        """Pixel coordinates of points in the camera's axes, which must be in front of it."""
        depth = 1.0 if self.parallel else np.maximum(seen[..., 2], self.near)
        x = self.width / 2 + self.offset[0] + seen[..., 0] / depth * self.across
        y = self.height / 2 + self.offset[1] - seen[..., 1] / depth * self.down
        return x, y

    # -- rays ----------------------------------------------------------------------------------------------------------

    def _middles(self, left: int, top: int, right: int, bottom: int) -> tuple[Array, Array]:
        """How far right and up of the camera's axis the middles of pixels are, at depth 1 or in metres (parallel)."""
        u = (np.arange(left, right) + (0.5 - self.width / 2 - self.offset[0])) / self.across
        v = (self.height / 2 + self.offset[1] - 0.5 - np.arange(top, bottom)) / self.down
        return u, v

    def rays(self, left: int, top: int, right: int, bottom: int) -> tuple[Array, Array]:
        """Starts and directions (h x w x 3 each) of the rays of a rectangle of pixels; depth is the ray's parameter."""
        u, v = self._middles(left, top, right, bottom)
        offsets = u[None, :, None] * self.axes[0] + v[:, None, None] * self.axes[1]
        if self.parallel:
            return self.position + offsets, np.broadcast_to(self.axes[2], offsets.shape)
        return np.broadcast_to(self.position, offsets.shape), self.axes[2] + offsets

    def rays_at(self, region: tuple[int, int, int, int], start: Array, axes: Array) -> tuple[Array, Array]:
        """The rays of a rectangle of a camera that is at `start` with these axes: 3 x h x w, or 3 x 1 x 1 where all are alike.

        One plane for each coordinate: that takes half the time of three numbers for each pixel.
        """
        u, v = self._middles(*region)
        right, up, forward = axes[:, :, None]
        first = start[:, None]
        spread = (up * v + (first if self.parallel else forward))[:, :, None] + (right * u)[:, None, :]
        return (spread, forward[:, :, None]) if self.parallel else (first[:, :, None], spread)


class RenderedPicture(Projection):
    """`width` x `height` pixels; `aspect` is the width of a pixel by its height."""

    def __init__(
        self,
        width: int,
        height: int,
        aspect: float,
        camera: Camera,
        background: tuple[int, int, int],
        offset: tuple[float, float] = (0.0, 0.0),
    ) -> None:
        metres = camera.metres if camera.metres is not None else 2 * math.tan(FIELD_OF_VIEW / 2)
        super().__init__(camera, width, height, height / metres / aspect, height / metres, offset)
        self.background = background
        self.colour: Array = np.empty((height, width, 3), np.float32)
        self.colour[:] = np.array(background, np.float32) / 255
        self.depth: Array = np.full((height, width), FAR, np.float32)
        self.kind: Array = np.zeros((height, width), np.uint8)
        self.shade: Array = np.zeros((height, width), np.float32)
        """The brightness of a pixel's surface, 0..1: what characters without colour show."""
        self.robot: Array = np.zeros((height, width), bool)
        """The pixels where a robot's links are, also behind what is drawn over them."""
        self.labels: list[PictureText] = []

    # -- writing -------------------------------------------------------------------------------------------------------

    def put(self, flat: Array, depth: Array, colour: Array, alpha: Any, kind: Any, shade: Any) -> None:
        """Colour pixels by their flat numbers, each at most once and already known to be nearest."""
        pixels = self.colour.reshape(-1, 3)
        opaque = np.ndim(alpha) == 0 and alpha >= 1
        if opaque:
            pixels[flat] = colour
        else:
            part = np.asarray(alpha, np.float32)
            part = part[:, None] if part.ndim else part
            pixels[flat] = colour * part + pixels[flat] * (1 - part)
        self.depth.reshape(-1)[flat] = depth
        self.kind.reshape(-1)[flat] = kind
        self.shade.reshape(-1)[flat] = shade

    def rgb(self, step: int = 4) -> Array:
        """The colours as numbers 0xRRGGBB (height x width), in steps that keep the number of styles small."""
        levels = np.clip(self.colour * 255 + 0.5, 0, 255).astype(np.uint32)
        if step > 1:
            exact = self.kind == EMPTY
            rounded = np.minimum(levels // step * step + step // 2, 255)
            levels = np.where(exact[..., None], levels, rounded)
        result: Array = levels[..., 0] << 16 | levels[..., 1] << 8 | levels[..., 2]
        return result
