"""The base of windows that show the newest image of a camera, in real pixels or characters.

They draw a few pictures a second, however many images come, and fewer where that takes long.
"""

from __future__ import annotations

import time
from collections.abc import Iterable
from dataclasses import replace
from typing import TYPE_CHECKING, Any, Protocol, TypeVar

from rich.segment import Segment
from textual import events
from textual.geometry import Region

from day6_core.ros.programs.rqt_image_view.decoding import DecodedImage, ImageRequest, Undecodable
from day6_core.session.display import Window
from day6_tui.appearance.colours import background_of
from day6_tui.appearance.look import Look
from day6_tui.panes.cells import wrap
from day6_tui.panes.pane import Piece
from day6_tui.panes.placement import PaneNeeds
from day6_tui.panes.splits import Extent
from day6_tui.windows import WindowPane
from day6_tui.windows.images.image_cells import in_cells, on_ground, pixels_in_cells

if TYPE_CHECKING:
    from day6_tui.pixels.pictures import Pictures

FRAME_SECONDS = 0.1
"""Between two pictures."""

RESTS = 6
"""After a picture that took long, so many times as long passes until the next."""


class HasPicture(Protocol):
    """What the window reads of a model."""

    @property
    def received(self) -> int:
        """How many images have come."""

    @property
    def version(self) -> int:
        """Grows when anything but the image changes."""

    @property
    def view(self) -> ImageRequest:
        """How the image is shown."""

    def picture(self, view: ImageRequest) -> DecodedImage | None:
        """The newest image as it is to be shown; None while there is none. Raises Undecodable."""


Shown = TypeVar("Shown", bound=HasPicture)


class PicturePane(WindowPane[Shown]):
    """Draws the newest image as the model's `view` says, below `head_lines` lines; keeps where the mouse is."""

    needs = PaneNeeds(Extent(24, 8), Extent(50, 16), Extent(120, 40), 2.0)

    head_lines = 0

    def __init__(self, window: Window[Shown], look: Look) -> None:
        super().__init__(window, look)
        self._picture: DecodedImage | None = None
        self._problem = ""
        self._lines: list[list[Segment]] = []
        self._corner = (0, 0)
        """The cell (column, row inside) of the picture's upper left corner."""
        self._cell = (1, 2)
        """Pixels across and down in a cell."""
        self._state: tuple[object, ...] = ()
        self._due = 0.0
        self._mouse: tuple[int, int] | None = None
        """The pixel of the image under the mouse."""

    @property
    def _room(self) -> tuple[int, int]:
        """Columns and rows for the picture."""
        return self.inner_width, max(0, self.inner_height - self.head_lines)

    # -- frames --------------------------------------------------------------------------------------------------------

    def pull(self, now: float) -> bool:
        state = (self.model.received, self.model.version, self._room, self.model.view, self.look.glyphs.canvas)
        if state == self._state:
            return False
        if now < self._due and self._state and state[1:] == self._state[1:]:
            return True
        began = time.monotonic()
        self._state = state
        self._draw()
        self._due = now + max(FRAME_SECONDS, RESTS * (time.monotonic() - began))
        self.touch_lines(range(self.inner_height))
        self.touch_frame()
        return False

    def restyle(self) -> None:
        self._state = ()
        super().restyle()

    def on_resize(self, event: events.Resize) -> None:
        super().on_resize(event)
        self._state = ()

    def _draw(self) -> None:
        columns, rows = self._room
        pictures = self.look.pixels
        self._picture, self._lines, self._problem = None, [], ""
        if columns < 2 or rows < 1:
            return
        across, down = (
            pixels_in_cells(1, 1, self.look.glyphs.canvas) if pictures is None else pictures.cell(columns, rows)
        )
        self._cell = across, down
        # A pixel of a cell without halves is twice as high as wide: of those pixels every second row is left out.
        thin = 2 if pictures is None and down == 1 else 1
        view = replace(self.model.view, width=columns * across, height=rows * down * thin)
        try:
            self._picture = self.model.picture(view)
        except Undecodable as error:
            self._problem = str(error)
        if self._picture is None or self._problem:
            if pictures is not None:
                pictures.drop(self)
            return
        if pictures is not None:
            self._show_pixels(pictures, self._picture.pixels, columns, rows)
            return
        pixels = self._picture.pixels[::thin]
        self._cell = across, down * thin
        self._lines = in_cells(pixels, self.look.glyphs.canvas, colourless=self.look.colours.colourless)
        self._corner = (columns - pixels.shape[1]) // 2, (rows - len(self._lines)) // 2

    def _show_pixels(self, pictures: Pictures, pixels: Any, columns: int, rows: int) -> None:
        """Draw in real pixels."""
        ground = max(0, background_of(self.background))
        whole, self._corner = on_ground(pixels, (columns, rows), self._cell, ground)
        region = Region(self.inner_offset, self.inner_offset + self.head_lines, columns, rows)
        pictures.show(self, region, self._cell, whole)

    def content_line(self, y: int, width: int) -> Iterable[Segment]:
        if y < self.head_lines:
            return self._head(width)
        colours, row = self.look.colours, y - self.head_lines - self._corner[1]
        remark = self._problem or ("" if self._picture is not None else self._remark())
        if remark:
            lines = wrap(remark[:2000], width - 2)
            style = colours.warning if self._problem else colours.muted
            at = y - self.head_lines - 1
            return [Segment(f" {lines[at]}", style)] if 0 <= at < len(lines) else ()
        if 0 <= row < len(self._lines):
            return [Segment(" " * self._corner[0], self.background), *self._lines[row]]
        return ()

    def _head(self, width: int) -> list[Segment]:
        """The line above the picture."""
        return []

    def _remark(self) -> str:
        """What is said while there is no image."""
        return ""

    def status(self) -> list[Piece]:
        picture, colours = self._picture, self.look.colours
        if picture is None:
            return []
        text = f" {picture.image_width}x{picture.image_height} {picture.encoding}  {self.model.received} "
        pieces = [Piece(text, colours.muted)]
        if self._mouse is not None:
            pieces.append(Piece(f" x {self._mouse[0]}  y {self._mouse[1]} ", colours.strong))
        return pieces

    # -- the mouse -----------------------------------------------------------------------------------------------------

    def _pixel_at(self, event: events.MouseEvent) -> tuple[int, int] | None:
        """The pixel of the shown image (turned, whole) under the mouse."""
        picture = self._picture
        if picture is None:
            return None
        x = (event.x - self.inner_offset - self._corner[0]) * self._cell[0]
        y = (event.y - self.inner_offset - self.head_lines - self._corner[1]) * self._cell[1]
        if not (0 <= x < len(picture.columns) and 0 <= y < len(picture.rows)):
            return None
        return int(picture.columns[x]), int(picture.rows[y])

    def on_mouse_move(self, event: events.MouseMove) -> None:
        at = self._pixel_at(event)
        if at != self._mouse:
            self._mouse = at
            self.touch_status()
            self.look.wake()

    def on_leave(self) -> None:
        self._mouse = None
        self.touch_status()
