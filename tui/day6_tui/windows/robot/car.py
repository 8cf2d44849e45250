"""The car from above: `day6_urdf.topview` draws it from the transforms of a `CarSnapshot`; problems are listed below it."""

from __future__ import annotations

from collections.abc import Iterable
from typing import TYPE_CHECKING

from rich.segment import Segment
from rich.style import Style
from textual import events
from textual.geometry import Region

from day6_core.session.display import Window
from day6_tui.appearance.colours import pixel_style
from day6_tui.appearance.look import Look
from day6_tui.panes.cells import clip
from day6_tui.panes.pane import Piece
from day6_tui.panes.placement import PaneNeeds
from day6_tui.panes.splits import Extent
from day6_tui.windows import WindowPane
from day6_tui.windows.parts.remarks import remark_lines
from day6_tui.windows.robot.top_colours import top_colours
from day6_urdf.topview.canvas import Row
from day6_urdf.topview.canvas import Style as CellStyle
from day6_urdf.topview.view import render_top

if TYPE_CHECKING:
    from day6_core.ros.programs.day6_bot.model import CarModel, CarSnapshot
    from day6_core.ros.programs.remark import Remark
    from day6_tui.pixels.pictures import Pictures
    from day6_tui.windows.robot.car_pixels import CarPicture


MOST_STATUS_LINES = 4
ROOM_FOR_EFFECTS = 24
"""Rows of a window from which more than the first remark is shown."""

FRAME_SECONDS = 0.05
"""Twenty pictures a second: a wheel turns smoothly, and drawing it costs a millisecond or two each time."""

ZOOM = 1.25
_ZOOMS = {"+": ZOOM, "=": ZOOM, "-": 1 / ZOOM, "_": 1 / ZOOM}
_PANS = {"left": (1, 0), "right": (-1, 0), "up": (0, 1), "down": (0, -1)}
"""Keys that move the view to a side: the picture moves the other way."""

_ROLES = {
    "": "text",
    "chassis": "node",
    "shade": "node",
    "lamp": "strong",
    "body": "node",
    "wheel": "strong",
    "mark": "topic",
    "tail": "topic",
    "caster": "muted",
    "arrow": "publisher",
    "axle": "muted",
    "label": "text",
    "name": "text",
    "missing": "warning",
    "scale": "muted",
}
"""Style in `topview.view.STYLES` -> role in `Colours`."""

_LEVELS = {"error": "warning", "warning": "topic", "info": "muted"}


class CarPane(WindowPane["CarModel"]):
    """Draws the newest snapshot; a new one costs the cells in which its picture differs."""

    needs = PaneNeeds(Extent(30, 10), Extent(46, 20), Extent(70, 30), 2.0)
    about = "robot"

    def __init__(self, window: Window[CarModel], look: Look) -> None:
        super().__init__(window, look)
        self._snapshot: CarSnapshot | None = None
        self._rows: list[Row] = []
        self._remarks: list[tuple[str, str]] = []
        self._drawn_at = 0.0
        self._zoom = 1.0
        self._shift = (0, 0)
        self._letters = False
        """Drawn with ASCII letters, whatever the terminal shows."""
        self._briefed = False
        """Somebody has pressed a key here: what needs no action is not said any more."""
        self._picture: CarPicture | None = None
        """The car in real pixels, where the terminal shows them."""

    # -- frames --------------------------------------------------------------------------------------------------------

    def pull(self, now: float) -> bool:
        snapshot = self.model.snapshot()
        if snapshot is self._snapshot and self._rows:
            return False
        if self._rows and now - self._drawn_at < FRAME_SECONDS:
            return True
        self._drawn_at = now
        before, remarks_before = self._rows, self._remarks
        rate_before = self._rate()
        self._take_over(snapshot)
        if (pictures := self.look.pixels) is not None:
            self._show_picture(pictures, snapshot)
        if remarks_before != self._remarks or len(before) != len(self._rows):
            self.touch()
            return False
        self.touch_lines(line for line, (old, new) in enumerate(zip(before, self._rows, strict=True)) if old != new)
        if rate_before != self._rate():
            self.touch_frame()
        return False

    def _take_over(self, snapshot: CarSnapshot) -> None:
        self._snapshot = snapshot
        self._remarks = self._remark_lines(snapshot.status)
        rows = max(0, self.inner_height - len(self._remarks))
        if snapshot.plan is None:
            self._rows = [[]] * rows
            return
        if self.look.pixels is not None and not self._letters:
            self._rows = [[]] * rows  # the picture has them
            return
        self._rows = list(
            render_top(
                snapshot.plan,
                snapshot.transforms,
                self.inner_width,
                rows,
                self._glyphs,
                labels=snapshot.labels(self._degree),
                turning=snapshot.turning(FRAME_SECONDS),
                colours=top_colours(self.look.colours),
                zoom=self._zoom,
                shift=self._shift,
            )
        )

    @property
    def _glyphs(self) -> str:
        """Dots need colours: without any the car is drawn with letters, as it is if somebody asks for that."""
        return "ascii" if self._letters or self.look.colours.colourless else self.look.glyphs.canvas

    @property
    def _degree(self) -> str:
        return "°" if self.look.glyphs.canvas in ("half", "braille") else " deg"

    def _show_picture(self, pictures: Pictures, snapshot: CarSnapshot) -> None:
        """Draw in real pixels."""
        from day6_tui.windows.robot.car_pixels import CarPicture

        if snapshot.plan is None or not self.inner_width or not self._rows or self._letters:
            pictures.drop(self)
            self._picture = None
            return
        size = self.inner_width, len(self._rows)
        cell, picture = pictures.cell(*size), self._picture
        if picture is None or (picture.columns, picture.rows, picture.cell) != (*size, cell):
            picture = self._picture = CarPicture(*size, cell, self.look.colours)
            self.touch()
        frame = picture.frame(snapshot.plan, self._zoom, self._shift)
        pixels = picture.pixels(frame, snapshot.transforms, snapshot.turning(FRAME_SECONDS))
        texts = picture.texts(frame, snapshot.transforms, snapshot.labels(self._degree), pixels)
        changed = picture.sheet.put(texts)
        pictures.show(self, Region(self.inner_offset, self.inner_offset, *size), cell, pixels, picture.sheet.holes)
        self.redraw_lines(changed)

    def _remark_lines(self, status: Iterable[Remark]) -> list[tuple[str, str]]:
        """Levels and lines of the remarks: the picture comes first, so in most windows the cause alone.

        What needs no action, of level "info", is left out in a low window, and once a key has been pressed here.
        """
        most = 1 if self.inner_height < ROOM_FOR_EFFECTS else MOST_STATUS_LINES
        wanted = [remark for remark in status if not (self._briefed and remark.level == "info")]
        return remark_lines(wanted, self.look, self.inner_width, most, info_needs_room=True)

    def on_resize(self, event: events.Resize) -> None:
        super().on_resize(event)
        self._rows = []

    def restyle(self) -> None:
        self._rows, self._picture = [], None
        super().restyle()

    # -- drawing -------------------------------------------------------------------------------------------------------

    def title(self) -> list[Piece]:
        robot = self._snapshot.robot if self._snapshot is not None else None
        name = [Piece(f" {robot.name} ", self.look.colours.node)] if robot is not None else []
        return [*super().title(), *name]

    def _rate(self) -> str:
        rate = self._snapshot.rate if self._snapshot is not None else None
        return f"/joint_states {rate:.0f} Hz" if rate is not None else ""

    def status(self) -> list[Piece]:
        rate = self._rate()
        return [Piece(f" {rate} ", self.look.colours.topic)] if rate else []

    def content_line(self, y: int, width: int) -> Iterable[Segment]:
        if not self._rows:
            self._take_over(self.model.snapshot())
        colours = self.look.colours
        if y < len(self._rows) and self._picture is not None and self.look.pixels is not None:
            return self._picture.sheet.line(y) if y < self._picture.rows else []
        if y < len(self._rows):
            return [Segment(text, self._style(style)) for text, style in self._rows[y]]
        index = y - len(self._rows)
        if index < len(self._remarks):
            level, text = self._remarks[index]
            return [Segment(clip(text, width, self.look.glyphs.ellipsis), getattr(colours, _LEVELS[level]))]
        return []

    def _style(self, style: CellStyle) -> Style:
        if isinstance(style, tuple):
            return pixel_style(*style)
        named: Style = getattr(self.look.colours, _ROLES.get(style, "text"))
        return named

    # -- keys ----------------------------------------------------------------------------------------------------------

    def key_hints(self) -> list[tuple[str, str]]:
        letters = [("b", self.look.texts("car.letters"))] if self._has_dots else []
        return [("+ - 0", self.look.texts("car.zoom")), *letters]

    @property
    def _has_dots(self) -> bool:
        """Whether there is anything but letters to draw with."""
        return self.look.glyphs.unicode and not self.look.colours.colourless

    def _press(self, key: str, character: str) -> bool:
        self._briefed = True
        if key == "b" and self._has_dots:
            self._letters = not self._letters
        elif character in _ZOOMS:
            self._zoom = min(max(self._zoom * _ZOOMS[character], 0.2), 20.0)
        elif key in _PANS:
            right, down = _PANS[key]
            self._shift = (self._shift[0] + 4 * right, self._shift[1] + 2 * down)
        elif character == "0":
            self._zoom, self._shift = 1.0, (0, 0)
        else:
            return False
        return True

    def _wheel(self, event: events.MouseEvent, notches: int) -> None:
        event.stop()
        self._zoom = max(self._zoom / ZOOM, 0.2) if notches > 0 else min(self._zoom * ZOOM, 20.0)
        self._redraw()

    def _redraw(self) -> None:
        self.restyle()
        self.look.wake()
