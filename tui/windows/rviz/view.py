"""The 3-D view: paints when something changed, at a rate the machine can sustain, and returns which cells to send."""

from __future__ import annotations

import time

from rich.segment import Segment

from day6_tui.core.ros.programs.rviz2.model.manager import RViz
from day6_tui.tui.canvas import PIXELS_PER_CELL, Span
from day6_tui.tui.look import Look
from day6_tui.tui.render.cells import Cells, cells_of, pixel_aspect
from day6_tui.tui.render.painter import QUALITIES, paint
from day6_tui.tui.render.picture import Array

MOVING_SECONDS = 1 / 15
"""Seconds between two pictures of a moving robot."""

DRAGGING_SECONDS = 1 / 30
"""… while the user turns it."""

SHARE = 0.2
"""The share of time that painting may take: a slow machine paints less often."""

SLOWEST_SECONDS = 1.0


class View3D:
    """Keeps the cells shown. `columns` x `rows` cells."""

    def __init__(self, rviz: RViz, look: Look) -> None:
        self._rviz = rviz
        self._look = look
        self.columns = self.rows = 0
        self.cells: Cells | None = None
        self._painted: tuple[object, ...] = ()
        self._painted_at = -10.0
        self._cost = 0.0
        """Seconds to paint a picture, averaged over the last ones."""
        self._times: list[float] = []
        self.dragging = False

    def resize(self, columns: int, rows: int) -> bool:
        """Take another size; True if it is one."""
        if (columns, rows) == (self.columns, self.rows):
            return False
        self.columns, self.rows = columns, rows
        self.cells = None
        return True

    def forget(self) -> None:
        """Paint everything anew."""
        self.cells = None

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

    def pull(self, now: float) -> tuple[list[Span], bool]:
        """Paint if something changed; return the spans that differ, and whether a picture is still due."""
        if not self.columns or not self.rows:
            return [], False
        rviz = self._rviz
        state = (rviz.version, rviz.view_version, rviz.quality.value, self._look.glyphs.name, self._look.colours.name)
        if self.cells is not None and state == self._painted:
            return [], False
        rviz.pace = self.period
        if self.cells is not None and now - self._painted_at < self.period * 0.9:
            return [], True
        self._painted, self._painted_at = state, now
        before, self.cells = self.cells, self._paint()
        spans = self.cells.changes(before)
        if spans:
            self._times.append(now)
        return spans, False

    def _paint(self) -> Cells:
        began = time.thread_time()
        mode, quality = self._look.glyphs.canvas, QUALITIES[self._rviz.quality.value]
        across, down = PIXELS_PER_CELL[mode]
        camera = self._rviz.view.camera()
        width, height = self.columns * across, self.rows * down
        picture = paint(self._rviz.scene, camera, width, height, pixel_aspect(mode), quality)
        cells = cells_of(picture, mode, quality.step, colourless=self._look.colours.colourless)
        self._cost = 0.7 * self._cost + 0.3 * (time.thread_time() - began)
        return cells

    def line(self, row: int) -> list[Segment]:
        """The segments of one row."""
        if self.cells is None:
            self.cells = self._paint()
        return self.cells.line(row) if row < self.rows else []

    def snapshot(self, height: int = 720) -> Array:
        """The view as a picture of square pixels, for a file: rows x columns of 0xRRGGBB."""
        width = max(1, round(height * self.columns / max(1, self.rows) / 2))
        picture = paint(self._rviz.scene, self._rviz.view.camera(), width, height, 1.0, QUALITIES["High"])
        return picture.rgb(1)
