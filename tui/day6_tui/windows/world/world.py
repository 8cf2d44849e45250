"""The world's window: `WorldModel`'s snapshots from above, and problems below. The world itself belongs to the program."""

from __future__ import annotations

import math
from collections.abc import Iterable
from dataclasses import replace
from typing import TYPE_CHECKING

from rich.segment import Segment
from textual import events
from textual.geometry import Region

from day6_core.session.display import Window
from day6_tui.appearance.look import Look
from day6_tui.panes.cells import clip
from day6_tui.panes.pane import Piece
from day6_tui.panes.placement import PaneNeeds
from day6_tui.panes.splits import Extent
from day6_tui.windows import WindowPane
from day6_tui.windows.parts.remarks import remark_lines
from day6_tui.windows.robot.top_colours import top_colours
from day6_tui.windows.world.picture import Rows, WorldPicture, WorldView, fitting, look_of, segments

if TYPE_CHECKING:
    from day6_core.ros.programs.day6_world.model import WorldModel, WorldSnapshot
    from day6_core.ros.programs.day6_world.scenery import Scenery
    from day6_core.ros.programs.remark import Remark
    from day6_tui.pixels.pictures import Pictures
    from day6_tui.windows.world.pixels import WorldPixels


FRAME_SECONDS = 0.05
"""Twenty pictures a second."""

ZOOM = 1.25
CLOSEST, FARTHEST = 0.002, 0.5
"""Metres for one pixel."""

MOST_STATUS_LINES = 5

_LEVELS = {"error": "warning", "warning": "topic", "info": "muted"}
_REQUESTS = {"space": "pause", "n": "step", "right_square_bracket": "faster", "left_square_bracket": "slower"}
_PANS = {"left": (-1, 0), "right": (1, 0), "up": (0, 1), "down": (0, -1)}


class WorldPane(WindowPane["WorldModel"]):
    """Draws the newest snapshot in its view; keeps the view and what is switched on."""

    needs = PaneNeeds(Extent(30, 10), Extent(46, 20), Extent(80, 36), 2.0)
    about = "robot"

    def __init__(self, window: Window[WorldModel], look: Look) -> None:
        super().__init__(window, look)
        self._snapshot: WorldSnapshot | None = None
        self._view: WorldView | None = None
        self._picture: WorldPicture | None = None
        self._rows: Rows = []
        self._remarks: list[tuple[str, str]] = []
        self._drawn_at = 0.0
        self._follow = False
        self._head: tuple[str, ...] = ()
        self._table: list[int] = []
        self._heading = -1
        self._drag: tuple[int, int] | None = None
        self._pixels: WorldPixels | None = None
        """The view in real pixels, where the terminal shows them."""

    # -- frames --------------------------------------------------------------------------------------------------------

    def pull(self, now: float) -> bool:
        snapshot = self.model.snapshot()
        if not self.inner_width or snapshot.scenery is None:
            return False
        if snapshot is self._snapshot and self._rows:
            self._touch_head()
            return False
        if self._rows and now - self._drawn_at < FRAME_SECONDS:
            return True
        self._drawn_at = now
        before, remarks_before, heading = self._rows, self._remarks, self._heading
        self._take_over(snapshot, snapshot.scenery)
        if remarks_before != self._remarks or len(before) != len(self._rows):
            self.touch()
            return False
        if self.look.pixels is not None:
            self._touch_head()
            return False
        per_line = 2 if self._mode() == "half" else 1
        changed = {y // per_line for y, (old, new) in enumerate(zip(before, self._rows, strict=True)) if old != new}
        if per_line == 1 and heading != self._heading:
            changed = set(range(len(self._rows)))
        self.redraw_lines(changed)
        self._touch_head()
        return False

    def _touch_head(self) -> None:
        head = tuple(piece.text for piece in (*self.status(), *self.status_right()))
        if head != self._head:
            self._head = head
            self.touch_status()

    def _mode(self) -> str:
        mode = self.look.glyphs.canvas
        if self.look.colours.colourless or mode == "ascii":
            return "ascii"
        return "cell" if mode == "cell" else "half"

    def _take_over(self, snapshot: WorldSnapshot, scenery: Scenery) -> None:
        self._snapshot = snapshot
        self._remarks = self._remark_lines(snapshot.status)
        rows = max(1, self.inner_height - len(self._remarks))
        view = self._next_view(snapshot, scenery, self.inner_width, rows)
        if self._picture is None or self._picture.view != view:
            self._picture = WorldPicture(view, scenery)
            self._view = view
        self._table = self._table or look_of(self.look.colours)
        self._heading = round(snapshot.pose[2] / (math.pi / 4)) % 8
        if (pictures := self.look.pixels) is not None:
            self._rows = self._rows or [bytearray()] * view.height
            self._show_pixels(pictures, view, snapshot, scenery)
        else:
            self._rows = self._picture.frame(snapshot, self.model.trail)

    def _show_pixels(self, pictures: Pictures, view: WorldView, snapshot: WorldSnapshot, scenery: Scenery) -> None:
        """Draw in real pixels."""
        from day6_tui.windows.world.pixels import WorldPixels

        cell, shown = pictures.cell(view.columns, view.rows), self._pixels
        if shown is None or (shown.view, shown.cell) != (view, cell):
            shown = self._pixels = WorldPixels(
                view, cell, scenery, self._table, top_colours(self.look.colours), self.background
            )
        place = Region(self.inner_offset, self.inner_offset, view.columns, view.rows)
        pictures.show(self, place, cell, shown.pixels(snapshot, self.model.trail))

    def _next_view(self, snapshot: WorldSnapshot, scenery: Scenery, columns: int, rows: int) -> WorldView:
        """The view as it was, in the size of the window; it moves along when the robot would leave it."""
        view = self._view
        if view is None:
            return fitting(scenery, columns, rows, self._mode())
        if (view.columns, view.rows, view.mode) != (columns, rows, self._mode()):
            whole = fitting(scenery, columns, rows, self._mode())
            view = replace(view, columns=columns, rows=rows, mode=self._mode()) if self._zoomed else whole
        x, y, _ = snapshot.pose
        if snapshot.robot is not None and (self._follow or not view.holds(x, y, 0.0)):
            # Whole pixels, so that a still world does not shimmer under the moving view.
            sx, sy = view.scale, view.scale_y
            if self._follow and view.holds(x, y, 0.35):
                return view
            view = replace(view, x=round(x / sx) * sx, y=round(y / sy) * sy)
        return view

    _zoomed = False

    def _remark_lines(self, status: Iterable[Remark]) -> list[tuple[str, str]]:
        """Levels and lines of the remarks, uncut."""
        most = max(MOST_STATUS_LINES, self.inner_height // 3)
        return remark_lines(status, self.look, self.inner_width, most)[: max(0, self.inner_height - 1)]

    def on_resize(self, event: events.Resize) -> None:
        super().on_resize(event)
        self._rows = []

    def restyle(self) -> None:
        self._rows, self._table, self._pixels = [], [], None
        super().restyle()

    # -- drawing -------------------------------------------------------------------------------------------------------

    def content_line(self, y: int, width: int) -> Iterable[Segment]:
        if not self._rows:
            snapshot = self.model.snapshot()
            if snapshot.scenery is None:
                return []  # the window is open before its program has read the world
            self._take_over(snapshot, snapshot.scenery)
        view, colours = self._view, self.look.colours
        if view is None:
            return []
        if y < view.rows and self._pixels is not None and self.look.pixels is not None:
            return self._pixels.sheet.line(y)
        if y < view.rows:
            yaw = self._snapshot.pose[2] if self._snapshot is not None else 0.0
            return segments(self._rows, y, view, self._table, colours, yaw)
        index = y - view.rows
        if index < len(self._remarks):
            level, text = self._remarks[index]
            return [Segment(clip(text, width, self.look.glyphs.ellipsis), getattr(colours, _LEVELS[level]))]
        return []

    def status(self) -> list[Piece]:
        snapshot = self._snapshot
        if snapshot is None or snapshot.robot is None:
            return []
        x, y, yaw = snapshot.pose
        # Never show "-0.00".
        x, y, speed = (round(value, 2) + 0.0 for value in (x, y, snapshot.velocity[0]))
        texts, colours = self.look.texts, self.look.colours
        degrees = round(math.degrees(yaw)) + 0
        text = texts("world.pose", x=x, y=y, degrees=degrees, v=speed)
        pieces = [Piece(f" {text if self.look.glyphs.unicode else text.replace('°', ' deg')} ", colours.text)]
        if snapshot.line:
            bars = self.look.glyphs.bars
            shown = "".join(bars[round(value * (len(bars) - 1))] for value in snapshot.line)
            pieces.append(Piece(f" {texts('world.line')} [{shown}] ", colours.topic))
        return pieces

    def status_right(self) -> list[Piece]:
        snapshot, colours = self._snapshot, self.look.colours
        if snapshot is None:
            return []
        factor = snapshot.real_time_factor
        if snapshot.paused or self.model.is_held():
            pace = f"  {self.look.texts('bar.paused')}"
        else:
            pace = "" if factor is None else f"  {self.look.texts('world.factor', factor=factor)}"
        return [Piece(f" {snapshot.seconds:.1f} s{pace} ", colours.node)]

    # -- keys and mouse ------------------------------------------------------------------------------------------------

    def key_hints(self) -> list[tuple[str, str]]:
        texts = self.look.texts
        return [
            ("+ -", texts("world.zoom")),
            ("f", texts("world.follow")),
            ("l", texts("world.lidar")),
            ("Space", texts("action.pause")),
            ("n", texts("world.step")),
            ("r", texts("world.reset")),
        ]

    def _press(self, key: str, character: str) -> bool:
        request = _REQUESTS.get(key) or {"[": "slower", "]": "faster", "r": "reset", "t": "clear"}.get(character)
        if request is not None:
            self.model.request(request)
        elif key in _PANS:
            self._pan(*(8 * step for step in _PANS[key]))
        elif character in ("+", "="):
            self._zoom(1 / ZOOM)
        elif character in ("-", "_"):
            self._zoom(ZOOM)
        elif character == "0":
            self._view, self._follow, self._zoomed = None, False, False
        elif character == "f":
            self._follow = not self._follow
        elif character == "l":
            self.model.wants_rays = not self.model.wants_rays
        else:
            return False
        return True

    def _zoom(self, factor: float) -> None:
        """Nearer or farther, about the robot if there is one."""
        view, snapshot = self._view, self._snapshot
        if view is None:
            return
        scale = min(max(view.scale * factor, CLOSEST), FARTHEST)
        x, y = snapshot.pose[:2] if snapshot is not None and snapshot.robot is not None else (view.x, view.y)
        share = scale / view.scale
        self._view = replace(view, x=x + (view.x - x) * share, y=y + (view.y - y) * share, scale=scale)
        self._zoomed = True

    def _pan(self, columns: int, lines: int) -> None:
        view = self._view
        if view is not None:
            self._view = replace(view, x=view.x + columns * view.scale, y=view.y + lines * view.scale)
            self._follow, self._zoomed = False, True

    def _redraw(self) -> None:
        self._rows = []
        self.touch()
        self.look.wake()

    def _wheel(self, event: events.MouseEvent, notches: int) -> None:
        event.stop()
        self._zoom(ZOOM if notches > 0 else 1 / ZOOM)
        self._redraw()

    def on_mouse_down(self, event: events.MouseDown) -> None:
        if event.button == 1 and self.is_inside(event):
            self._drag = (event.x, event.y)
            self.capture_mouse()

    def on_mouse_move(self, event: events.MouseMove) -> None:
        if self._drag is not None and (event.x, event.y) != self._drag:
            self._pan(self._drag[0] - event.x, 2 * (event.y - self._drag[1]))
            self._drag = (event.x, event.y)
            self._redraw()

    def on_mouse_up(self, event: events.MouseUp) -> None:
        if self._drag is not None:
            self._drag = None
            self.release_mouse()
