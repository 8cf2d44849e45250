"""RViz' view in real pixels: a quick picture while something moves, and a smooth one, the mean of several, once all is still."""

from __future__ import annotations

import time

import numpy as np

from day6_core.ros.programs.rviz2.model.manager import RViz
from day6_core.ros.programs.rviz2.model.scene import Shape
from day6_tui.appearance.colours import pixel_style
from day6_tui.appearance.look import Look
from day6_tui.pixels.pictures import Pictures
from day6_tui.pixels.sheet import Sheet, Text
from day6_tui.render.cells import cells_covered, chip_of
from day6_tui.render.label_places import LabelPlaces
from day6_tui.render.painter import QUALITIES, paint
from day6_tui.render.picture import Array, RenderedPicture

DRAFT_PIXELS = 120_000
"""Of a picture of something moving: a robot in so many takes 10 to 20 ms."""

SMOOTH_PIXELS = 480_000
"""Of one that stands still: each of its parts keeps keys waiting for some 50 ms at most."""

SHARE = 0.3
"""The share of time that painting may take: a slow machine paints less often."""

STILL_SECONDS = 0.25
"""Without a change for so long, the smooth picture is worth its time."""

PASSES = ((0.125, 0.375), (-0.375, 0.125), (0.375, -0.125), (-0.125, -0.375))
"""Parts of a pixel by which the pictures of the smooth one are moved."""


class PixelView:
    """The picture shown in `columns` x `rows` cells, and the cells below it."""

    def __init__(self, rviz: RViz, look: Look, columns: int, rows: int) -> None:
        self._rviz, self._look = rviz, look
        self.sheet = Sheet(columns, rows, look.colours.text)
        self._places = LabelPlaces()
        self.cell = (1, 1)
        self.focus: Shape | None = None
        """What marks the focal point."""
        self.cursor: tuple[int, int] | None = None
        """The cell in which the keys point at things."""
        self.pixels: Array = np.zeros((rows, columns, 3), np.uint8)
        self._draft: Array | None = None
        """The quick picture painted last."""
        self._sum: Array | None = None
        self._passes = len(PASSES)
        self._changed_at = 0.0
        self._cost = 0.0
        """Seconds to paint a picture of something moving, averaged over the last ones."""

    @property
    def period(self) -> float:
        """Seconds between two pictures that painting takes at least."""
        return self._cost / SHARE

    def draft(self, pictures: Pictures, now: float) -> list[int]:
        """Paint what has changed, as finely as there is time for; return the rows of changed text."""
        began = time.thread_time()
        cell = pictures.cell(*self._size, most=DRAFT_PIXELS)
        picture = self._paint(cell)
        pixels = _bytes(picture.colour)
        self._cost = 0.7 * self._cost + 0.3 * (time.thread_time() - began)
        if self._draft is None or not np.array_equal(pixels, self._draft):  # else a message said the same again
            self._changed_at, self._passes, self._sum = now, 0, None
            self.pixels, self.cell, self._draft = pixels, cell, pixels
        return self._put_labels(picture)

    def smooth(self, pictures: Pictures, now: float) -> tuple[bool, bool]:
        """Paint one more part of the smooth picture if it is time; return whether it is done now, and whether more is due."""
        if self._passes == len(PASSES):
            return False, False
        if now - self._changed_at < STILL_SECONDS:
            return False, True
        cell = pictures.cell(*self._size, most=SMOOTH_PIXELS)
        colour = self._paint(cell, PASSES[self._passes]).colour
        if self._sum is None or self._sum.shape != colour.shape:
            self._sum, self._passes = colour, 0
        else:
            self._sum = self._sum + colour
        self._passes += 1
        if self._passes < len(PASSES):
            return False, True
        self.pixels, self.cell = _bytes(self._sum / len(PASSES)), cell
        self._sum = None
        return True, False

    @property
    def _size(self) -> tuple[int, int]:
        return self.sheet.columns, self.sheet.rows

    def _paint(self, cell: tuple[int, int], offset: tuple[float, float] = (0.0, 0.0)) -> RenderedPicture:
        columns, rows = self._size
        width, height = columns * cell[0], rows * cell[1]
        quality = QUALITIES[self._rviz.quality.value]
        scene = self._rviz.scene.beside(self.focus)
        return paint(scene, self._rviz.view.camera(), width, height, 1.0, quality, offset)

    def _put_labels(self, picture: RenderedPicture) -> list[int]:
        red, green, blue = picture.background
        ground, chip = red << 16 | green << 8 | blue, chip_of(picture.background)
        texts: list[Text] = []
        if self.cursor is not None:
            texts.append((*self.cursor, "╋", pixel_style(CURSOR, ground)))
        across, down = self.cell
        wanted = [text._replace(x=text.x / across, y=text.y / down) for text in picture.labels]
        robot = cells_covered(picture.robot, across, down)
        for pieces, text in zip(self._places.place(wanted, *self._size, robot), wanted, strict=True):
            red, green, blue = text.colour
            style = pixel_style(red << 16 | green << 8 | blue, chip if text.is_name else ground)
            texts += [(*piece, style) for piece in pieces]
        return self.sheet.put(texts)


CURSOR = 0xFFFF00


def _bytes(colour: Array) -> Array:
    result: Array = (np.clip(colour, 0, 1) * 255 + 0.5).astype(np.uint8)
    return result
