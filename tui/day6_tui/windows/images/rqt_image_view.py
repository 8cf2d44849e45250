"""The window of rqt_image_view: the newest image of a topic, and how it is shown."""

from __future__ import annotations

from dataclasses import replace
from functools import partial
from typing import TYPE_CHECKING

from rich.segment import Segment
from textual import events

from day6_core.reason import reason
from day6_core.ros.programs.rqt_image_view.decoding import DecodedImage, ImageRequest
from day6_tui.overlays.menu import Menu, MenuEntry
from day6_tui.overlays.prompt import before_replacing
from day6_tui.panes.pane import Piece
from day6_tui.windows.images.picture_pane import PicturePane
from day6_tui.windows.parts.buttons import Button, button_line, shortened

if TYPE_CHECKING:
    from day6_core.ros.programs.rqt_image_view.model import ImageView

PAN = {"left": (-1, 0), "right": (1, 0), "up": (0, -1), "down": (0, 1)}
PAN_SHARE = 8
"""A key moves the part that is seen by its size divided by this."""


class ImageViewPane(PicturePane["ImageView"]):
    """Draws the newest image below a line with the topic, and changes the model's `view`."""

    model: ImageView
    head_lines = 1

    @property
    def _view(self) -> ImageRequest:
        return self.model.view

    @_view.setter
    def _view(self, view: ImageRequest) -> None:
        self.model.view = view

    def _remark(self) -> str:
        model, texts = self.model, self.look.texts
        if not model.topic:
            return texts("images.choose" if model.topics else "images.none")
        if model.topic not in model.topics:
            return texts("images.no_topic", topic=model.topic)
        return texts("images.waiting", topic=model.topic)

    def _head(self, width: int) -> list[Segment]:
        return button_line(self, 0, shortened(self._buttons(), width, self.look.glyphs.ellipsis), width)

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
        pieces = super().status()
        if pieces and self.model.topic not in self.model.topics:  # what is seen is the last image
            text = self.look.texts("images.no_topic", topic=self.model.topic)
            pieces.insert(1, Piece(f" {self.look.glyphs.warning} {text} ", self.look.colours.warning))
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

    def _pan(self, x: int, y: int, picture: DecodedImage) -> None:
        """Move the part that is seen, not beyond the image."""
        across, down = len(picture.columns), len(picture.rows)
        left = min(max(0, self._view.left + x * max(1, across // PAN_SHARE)), picture.image_width - across)
        top = min(max(0, self._view.top + y * max(1, down // PAN_SHARE)), picture.image_height - down)
        self._view = replace(self._view, left=left, top=top)

    def _choose_topic(self) -> None:
        entries = [
            MenuEntry(name, kind.rpartition("/")[2], partial(self.model.choose, name))
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
                return reason(error)
            return None

        sure = before_replacing(self.look, lambda text: model.path(text.strip()), taken)
        self.ask(self.look.texts("images.save_title"), "image.png", sure, note="*.bmp *.jpg *.png *.tiff")

    # -- the mouse -----------------------------------------------------------------------------------------------------

    def on_mouse_down(self, event: events.MouseDown) -> None:
        at = self._pixel_at(event)
        if event.button == 1 and at is not None and self._picture is not None:
            self.model.click(*self._unturned(*at, self._picture))

    def _unturned(self, x: int, y: int, picture: DecodedImage) -> tuple[int, int]:
        """The place in the image as it was sent (image_view.cpp, onMouseLeft)."""
        width, height = picture.image_width, picture.image_height
        return ((x, y), (y, width - x), (width - x, height - y), (height - y, x))[self._view.rotation]
