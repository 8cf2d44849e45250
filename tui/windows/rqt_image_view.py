"""The window of rqt_image_view: the newest image of a topic, in real pixels or characters.

It draws a few pictures a second, however many images come, and fewer where that takes long.
"""

from __future__ import annotations

import time
from collections.abc import Iterable
from dataclasses import replace
from functools import partial
from typing import TYPE_CHECKING, Any

from rich.segment import Segment
from textual import events
from textual.geometry import Region

from day6_tui.core.ros.programs.rqt_image_view.decoding import Picture, Undecodable, View
from day6_tui.core.session.display import Window
from day6_tui.tui.cells import wrap
from day6_tui.tui.colours import background_of
from day6_tui.tui.look import Look
from day6_tui.tui.menu import Entry, Menu
from day6_tui.tui.pane import Piece
from day6_tui.tui.prompt import before_replacing
from day6_tui.tui.windows import WindowPane
from day6_tui.tui.windows.buttons import Button, button_line, shortened
from day6_tui.tui.windows.image_cells import in_cells, on_ground, pixels_in_cells

if TYPE_CHECKING:
    from day6_tui.core.ros.programs.rqt_image_view.model import ImageView
    from day6_tui.tui.pixels.pictures import Pictures

FRAME_SECONDS = 0.1
"""Between two pictures."""

RESTS = 6
"""After a picture that took long, so many times as long passes until the next."""

PAN = {"left": (-1, 0), "right": (1, 0), "up": (0, -1), "down": (0, 1)}
PAN_SHARE = 8
"""A key moves the part that is seen by its size divided by this."""


class ImageViewPane(WindowPane["ImageView"]):
    """Draws the newest image as the model's `view` says; keeps where the mouse is."""

    def __init__(self, window: Window[ImageView], look: Look) -> None:
        super().__init__(window, look)
        self._picture: Picture | None = None
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
    def _view(self) -> View:
        return self.model.view

    @_view.setter
    def _view(self, view: View) -> None:
        self.model.view = view

    # -- frames --------------------------------------------------------------------------------------------------------

    @property
    def _room(self) -> tuple[int, int]:
        """Columns and rows for the picture."""
        return self.inner_width, max(0, self.inner_height - 1)

    def pull(self, now: float) -> bool:
        state = (self.model.received, self.model.version, self._room, self._view, self.look.glyphs.canvas)
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
        view = replace(self._view, width=columns * across, height=rows * down * thin)
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
        pictures.show(self, Region(self.inner_offset, self.inner_offset + 1, columns, rows), self._cell, whole)

    def content_line(self, y: int, width: int) -> Iterable[Segment]:
        if y == 0:
            return button_line(self, y, shortened(self._buttons(), width, self.look.glyphs.ellipsis), width)
        colours, row = self.look.colours, y - 1 - self._corner[1]
        remark = self._remark()
        if remark:
            lines = wrap(remark[:2000], width - 2)
            style = colours.warning if self._problem else colours.muted
            return [Segment(f" {lines[y - 2]}", style)] if 0 <= y - 2 < len(lines) else ()
        if 0 <= row < len(self._lines):
            return [Segment(" " * self._corner[0], self.background), *self._lines[row]]
        return ()

    def _remark(self) -> str:
        """What is said in place of a picture."""
        model, texts = self.model, self.look.texts
        if self._problem:
            return self._problem
        if self._picture is not None:
            return ""
        if not model.topic:
            return texts("images.choose" if model.topics else "images.none")
        if model.topic not in model.topics:
            return texts("images.no_topic", topic=model.topic)
        return texts("images.waiting", topic=model.topic)

    def _buttons(self) -> list[Button]:
        """The controls of the original; a click on one is its key."""
        model, view, texts = self.model, self._view, self.look.texts
        mark = " ▾" if self.look.glyphs.chinese else " v"
        publishes = model.mouse_topic if model.publishes_clicks else texts("images.mouse")
        return [
            Button("t", model.topic or "-", self._choose_topic, mark=mark),
            Button("1", "1:1", partial(self._press, "", "1"), view.zoom_1),
            Button("r", f"{90 * view.rotation}°", partial(self._press, "", "r")),
            Button("d", texts("images.dynamic"), partial(self._press, "", "d"), view.dynamic_range),
            Button("m", publishes, partial(self._press, "", "m"), model.publishes_clicks),
        ]

    def status(self) -> list[Piece]:
        picture, colours = self._picture, self.look.colours
        if picture is None:
            return []
        text = f" {picture.image_width}x{picture.image_height} {picture.encoding}  {self.model.received} "
        pieces = [Piece(text, colours.muted)]
        if self.model.topic not in self.model.topics:  # what is seen is the last image
            text = self.look.texts("images.no_topic", topic=self.model.topic)
            pieces.append(Piece(f" {self.look.glyphs.warning} {text} ", colours.warning))
        if self._mouse is not None:
            pieces.append(Piece(f" x {self._mouse[0]}  y {self._mouse[1]} ", colours.strong))
        return pieces

    # -- keys ----------------------------------------------------------------------------------------------------------

    def key_hints(self) -> list[tuple[str, str]]:
        texts, zoomed = self.look.texts, self._view.zoom_1
        arrows = "←↑↓→" if self.look.glyphs.unicode else "arrows"
        return [
            ("t", texts("images.topic")),
            ("1", texts("images.fit" if zoomed else "images.zoom_1")),
            *([(arrows, texts("rqt.pan"))] if zoomed else []),
            ("r", texts("images.rotate")),
            ("w", texts("images.save")),
        ]

    def more_key_hints(self) -> list[tuple[str, str]]:
        texts = self.look.texts
        return [
            ("R", texts("images.rotate_back")),
            ("d", texts("images.dynamic")),
            ("x", texts("images.range")),
            ("m", texts("images.mouse")),
        ]

    def on_key(self, event: events.Key) -> None:
        if self._press(event.key, event.character or ""):
            event.stop()
            event.prevent_default()

    def _press(self, key: str, character: str) -> bool:
        view = self._view
        if character == "t" or key == "enter":
            self._choose_topic()
        elif character == "1":
            self._view = replace(view, zoom_1=not view.zoom_1)
        elif character in ("r", "R") and character:
            self._view = replace(view, rotation=(view.rotation + (1 if character == "r" else 3)) % 4)
        elif character == "d":
            self._view = replace(view, dynamic_range=not view.dynamic_range)
        elif character == "x":
            self._ask_range()
        elif character == "m":
            self.model.publish_clicks(not self.model.publishes_clicks)
        elif key in ("ctrl+s", "w"):
            self._ask_file()
        elif key in PAN and view.zoom_1 and self._picture is not None:
            self._pan(*PAN[key], self._picture)
        else:
            return False
        self.look.wake()
        return True

    def _pan(self, x: int, y: int, picture: Picture) -> None:
        """Move the part that is seen, not beyond the image."""
        across, down = len(picture.columns), len(picture.rows)
        left = min(max(0, self._view.left + x * max(1, across // PAN_SHARE)), picture.image_width - across)
        top = min(max(0, self._view.top + y * max(1, down // PAN_SHARE)), picture.image_height - down)
        self._view = replace(self._view, left=left, top=top)

    def _choose_topic(self) -> None:
        entries = [
            Entry(name, kind.rpartition("/")[2], partial(self.model.choose, name))
            for name, kind in self.model.topics.items()
        ]
        if entries:
            names = list(self.model.topics)
            at = names.index(self.model.topic) if self.model.topic in names else 0
            self.lay_over(Menu(self.look, "topics.columns.topic", entries, chosen=at))

    def _ask_range(self) -> None:
        texts = self.look.texts

        def taken(text: str) -> str | None:
            try:
                most = float(text)
            except ValueError:
                most = -1.0
            if not 0.01 <= most <= 100.0:
                return texts("images.bad_range")
            self._view = replace(self._view, max_range=most, dynamic_range=False)
            self.look.wake()
            return None

        self.ask(texts("images.range"), f"{self._view.max_range:g}", taken, note=texts("images.range_note"))

    def _ask_file(self) -> None:
        model = self.model

        def taken(text: str) -> str | None:
            try:
                model.save(text.strip(), self._view)
            except (OSError, ValueError) as error:
                return (error.strerror if isinstance(error, OSError) else None) or str(error)
            return None

        sure = before_replacing(self.look, lambda text: model.path(text.strip()), taken)
        self.ask(self.look.texts("images.save_title"), "image.png", sure, note="*.bmp *.jpg *.png *.tiff")

    # -- the mouse -----------------------------------------------------------------------------------------------------

    def _pixel_at(self, event: events.MouseEvent) -> tuple[int, int] | None:
        """The pixel of the shown image (turned, whole) under the mouse."""
        picture = self._picture
        if picture is None:
            return None
        x = (event.x - self.inner_offset - self._corner[0]) * self._cell[0]
        y = (event.y - self.inner_offset - 1 - self._corner[1]) * self._cell[1]
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

    def on_mouse_down(self, event: events.MouseDown) -> None:
        at = self._pixel_at(event)
        if event.button == 1 and at is not None and self._picture is not None:
            self.model.click(*self._unturned(*at, self._picture))

    def _unturned(self, x: int, y: int, picture: Picture) -> tuple[int, int]:
        """The place in the image as it was sent (image_view.cpp, onMouseLeft)."""
        width, height = picture.image_width, picture.image_height
        return ((x, y), (y, width - x), (width - x, height - y), (height - y, x))[self._view.rotation]
