"""The car from above in real pixels; what is written beside it stays text."""

from __future__ import annotations

from collections.abc import Mapping
from typing import TYPE_CHECKING

import numpy as np
from rich.style import Style

from day6_tui.appearance.colours import Colours, background_of, foreground_of, pixel_style
from day6_tui.panes.cells import cell_len
from day6_tui.pixels.raster import Surface
from day6_tui.pixels.sheet import Sheet, Text
from day6_tui.windows.robot.robot_pixels import SurfacePainter
from day6_tui.windows.robot.top_colours import top_colours
from day6_urdf.kinematics import Transform
from day6_urdf.topview.frame import TopFrame
from day6_urdf.topview.paint import Turning, paint_top
from day6_urdf.topview.plan import TopPlan
from day6_urdf.topview.words import Labels, Word, words_of

if TYPE_CHECKING:
    from day6_tui.pixels.bands import Array


class CarPicture:
    """`columns` x `rows` cells of `cell` pixels. The car faces right, to scale."""

    def __init__(self, columns: int, rows: int, cell: tuple[int, int], colours: Colours) -> None:
        self.columns, self.rows, self.cell = columns, rows, cell
        self.sheet = Sheet(columns, rows, colours.text)
        self._colours = colours

    def frame(self, plan: TopPlan, zoom: float, shift: tuple[int, int]) -> TopFrame:
        """Where the robot lies; `zoom` and `shift` (columns, rows) as `topview.view.render_top` has them."""
        shape = self.cell[1] / self.cell[0]
        return TopFrame(plan, self.columns, self.rows, self.cell, thick=1.0, shape=shape, zoom=zoom, shift=shift)

    def pixels(self, frame: TopFrame, transforms: Mapping[str, Transform], turning: Turning) -> Array:
        """The picture of these transforms."""
        surface = Surface(frame.width, frame.height, max(0, background_of(self._colours.text)))
        painter = SurfacePainter(surface, frame.place, frame.metre)
        paint_top(painter, frame, transforms, top_colours(self._colours), turning)
        return surface.pixels()

    def texts(self, frame: TopFrame, transforms: Mapping[str, Transform], labels: Labels, pixels: Array) -> list[Text]:
        """Readings beside the wheels, lengths of axles, a scale: each on the colour that the picture has there."""
        styles = {"label": self._colours.text, "missing": self._colours.warning}
        return [
            (word.column, word.row, word.text, self._over(pixels, word, styles.get(word.role, self._colours.muted)))
            for word in words_of(frame, transforms, labels)
        ]

    def _over(self, pixels: Array, word: Word, style: Style) -> Style:
        """The style of a word on the robot: in the colour of texts, whatever it says, to be read on any part."""
        width, height = self.cell
        left, right = word.column * width, (word.column + cell_len(word.text)) * width
        below = pixels[word.row * height : (word.row + 1) * height, max(0, left) : max(0, right)]
        if not below.size:
            return style
        red, green, blue = (int(part) for part in np.median(below.reshape(-1, 3), axis=0))
        ground = red << 16 | green << 8 | blue
        if ground == max(0, background_of(self._colours.text)):
            return style
        return pixel_style(foreground_of(self._colours.text), ground)
