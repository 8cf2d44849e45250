"""The 3-D view: paints when something changed, at a rate the machine can sustain, and returns which cells to send."""

from __future__ import annotations

import time
from typing import TYPE_CHECKING

from rich.segment import Segment
from textual.geometry import Region
from textual.widget import Widget

from day6_core.ros.programs.rviz2.model.manager import RViz
from day6_core.ros.programs.rviz2.model.scene import Shape
from day6_core.ros.programs.rviz2.model.tools.tool import Pointer
from day6_tui.appearance.look import Look
from day6_tui.panes.canvas import PIXELS_PER_CELL
from day6_tui.render.cells import Cells, cells_of, pixel_aspect
from day6_tui.render.label_places import LabelPlaces
from day6_tui.render.painter import QUALITIES, paint, paint_grids
from day6_tui.render.picking import Screen, point_at
from day6_tui.render.picture import Array, PictureText

if TYPE_CHECKING:
    from day6_tui.pixels.pictures import Pictures
    from day6_tui.windows.rviz.pixels import PixelView

MOVING_SECONDS = 1 / 15
"""Seconds between two pictures of a moving robot."""

DRAGGING_SECONDS = 1 / 30
"""… while the user turns it."""

SHARE = 0.2
"""The share of time that painting may take: a slow machine paints less often."""

SLOWEST_SECONDS = 1.0

SMALL = 1000
"""Cells of a picture that is so small that its grids are drawn as finely as characters can; in a larger one that takes longer."""

FINER = 2
"""Pixels of braille across or down for one of half blocks."""

FOCUS_SECONDS = 0.6
"""How long a key shows the focal point."""

CURSOR = (255, 255, 0)
"""Its colour."""


class View3D:
    """Keeps the cells shown. `columns` x `rows` cells."""

    def __init__(self, rviz: RViz, look: Look) -> None:
        self._rviz = rviz
        self._look = look
        self.columns = self.rows = 0
        self.cells: Cells | None = None
        self._fine: PixelView | None = None
        """The cells as real pixels, where the terminal shows them."""
        self._places = LabelPlaces(unicode=look.glyphs.unicode)
        self._painted: tuple[object, ...] = ()
        self._painted_at = -10.0
        self._cost = 0.0
        """Seconds to paint a picture, averaged over the last ones."""
        self._times: list[float] = []
        self.dragging = False
        self._focus_shown = False
        self._turned_at = -10.0
        """When a key moved the camera."""
        self.cursor: tuple[int, int] | None = None
        """The cell in which the keys point at things, while a tool is used with them."""

    @property
    def screen(self) -> Screen:
        """The camera and the size, for picking."""
        return Screen(self._rviz.view.camera(), self.columns, self.rows)

    @property
    def focus(self) -> Shape | None:
        """What marks the focal point, while the camera is moved."""
        return self._rviz.view.focal_shape if self._focus_shown else None

    def pointer(self, x: float, y: float, *, search: bool) -> Pointer:
        """What a place (in cells, with fractions) points to; `search` for things, too."""
        return point_at(self._rviz.scene, self.screen, x, y, search=search)

    def resize(self, columns: int, rows: int) -> bool:
        """Take another size; True if it is one."""
        if (columns, rows) == (self.columns, self.rows):
            return False
        self.columns, self.rows = columns, rows
        self.cells = self._fine = self.cursor = None
        return True

    def forget(self) -> None:
        """Paint everything anew."""
        self.cells = self._fine = None
        self._places = LabelPlaces(unicode=self._look.glyphs.unicode)

    def turned(self) -> None:
        """A key moves the camera: its focal point is shown for a moment, as while the mouse does."""
        self._turned_at = time.monotonic()

    @property
    def aspect(self) -> float:
        """The picture's width by its height; a cell is half as wide as high."""
        return self.columns / max(1, self.rows) / 2

    @property
    def period(self) -> float:
        """Seconds between two pictures at present."""
        wanted = DRAGGING_SECONDS if self.dragging else MOVING_SECONDS
        rate = max(1, int(self._rviz.frame_rate.value))
        return min(SLOWEST_SECONDS, max(wanted, 1 / rate, self._cost / SHARE))

    @property
    def rate(self) -> float:
        """Pictures in the last second."""
        now = time.monotonic()
        self._times = [moment for moment in self._times if now - moment < 1.0]
        return float(len(self._times))

    def pull(self, now: float) -> tuple[list[int], bool]:
        """Paint if something changed; return the rows that differ, and whether a picture is still due."""
        if not self.columns or not self.rows:
            return [], False
        rviz = self._rviz
        looks = (rviz.quality.value, self._look.glyphs.name, self._look.colours.name)
        brief = time.monotonic() - self._turned_at < FOCUS_SECONDS
        self._focus_shown = brief or self.dragging
        state = (rviz.version, rviz.view_version, self.cursor, self._focus_shown, *looks)
        if (pictures := self._look.pixels) is not None:
            changed, due = self._pull_pixels(pictures, state, now)
            return changed, due or brief
        if self.cells is not None and state == self._painted:
            return [], brief
        rviz.pace = self.period
        if self.cells is not None and now - self._painted_at < self.period * 0.9:
            return [], True
        self._painted, self._painted_at = state, now
        before, self.cells = self.cells, self._paint()
        changed = self.cells.changes(before)
        if changed:
            self._times.append(now)
        return changed, brief

    def _pull_pixels(self, pictures: Pictures, state: tuple[object, ...], now: float) -> tuple[list[int], bool]:
        from day6_tui.windows.rviz.pixels import PixelView

        fine = self._fine
        if fine is not None and state == self._painted:
            done, due = fine.smooth(pictures, now)
            return [], due or done
        period = MOVING_SECONDS if fine is None else max(MOVING_SECONDS, fine.period)
        self._rviz.pace = period
        if fine is not None and now - self._painted_at < period * 0.9:
            return [], True
        self._painted, self._painted_at = state, now
        self._times.append(now)
        everything = list(range(self.rows)) if fine is None else []
        fine = self._fine = fine or PixelView(self._rviz, self._look, self.columns, self.rows)
        fine.cursor, fine.focus = self.cursor, self.focus
        changed = fine.draft(pictures, now)
        return everything or changed, True

    def show(self, pane: Widget, place: Region, *, covered: int) -> None:
        """Hand the picture over, if it is one of real pixels; `covered` of its lowest rows are text."""
        if (pictures := self._look.pixels) is None:
            return
        if self._fine is None or not self.columns or not self.rows:
            pictures.drop(pane)
        else:
            text = Region(0, self.rows - covered, self.columns, covered)
            holes = [*self._fine.sheet.holes, *([text] if covered else [])]
            pictures.show(pane, place, self._fine.cell, self._fine.pixels, holes)

    def _paint(self) -> Cells:
        began = time.thread_time()
        mode, quality = self._look.glyphs.canvas, QUALITIES[self._rviz.quality.value]
        across, down = PIXELS_PER_CELL[mode]
        camera = self._rviz.view.camera()
        width, height = self.columns * across, self.rows * down
        scene, fine = self._rviz.scene.beside(self.focus), self._has_fine_grids
        picture = paint(scene, camera, width, height, pixel_aspect(mode), quality, grids=not fine)
        grids = paint_grids(picture, scene, FINER) if fine else None
        if self.cursor is not None:
            x, y = (self.cursor[0] + 0.5) * across, (self.cursor[1] + 0.5) * down
            picture.labels.insert(0, PictureText(x, y, self._cross, CURSOR))
        colourless = self._look.colours.colourless
        cells = cells_of(picture, mode, quality.step, colourless=colourless, places=self._places, grids=grids)
        self._cost = 0.7 * self._cost + 0.3 * (time.thread_time() - began)
        return cells

    @property
    def _has_fine_grids(self) -> bool:
        """Whether grids are in braille, as half blocks are as thick as a robot in a small picture. On a map they are seen only as
        a part of the picture."""
        is_small = self.columns * self.rows < SMALL
        return is_small and self._look.glyphs.canvas == "half" and not self._rviz.scene.images

    @property
    def _cross(self) -> str:
        return "╋" if self._look.glyphs.unicode else "+"

    def line(self, row: int) -> list[Segment]:
        """The segments of one row."""
        if self._look.pixels is not None:
            return self._fine.sheet.line(row) if self._fine is not None and row < self.rows else []
        if self.cells is None:
            self.cells = self._paint()
        return self.cells.line(row) if row < self.rows else []

    def snapshot(self, height: int = 720) -> Array:
        """The view as a picture of square pixels, for a file: rows x columns of 0xRRGGBB."""
        width = max(1, round(height * self.columns / max(1, self.rows) / 2))
        picture = paint(self._rviz.scene, self._rviz.view.camera(), width, height, 1.0, QUALITIES["High"])
        return picture.rgb(1)
