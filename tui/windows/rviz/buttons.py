"""The buttons below the tree of the Displays panel: RViz's names, its order, its keys."""

from __future__ import annotations

from collections.abc import Callable
from functools import partial
from typing import NamedTuple

from rich.segment import Segment

from day6_tui.core.ros.programs.rviz2.model.display import Display
from day6_tui.tui.look import Look


class Button(NamedTuple):
    """`press` is None for one that can do nothing now."""

    name: str
    letter: str
    """Its key with Ctrl."""
    press: Callable[[], object] | None

    @property
    def key(self) -> str:
        return f"ctrl+{self.letter}"


class Place(NamedTuple):
    """Where a button is: its first column and the one behind its last."""

    first: int
    end: int


class Buttons:
    """The row of buttons. `chosen` is the one that has the keyboard, None while the tree has it."""

    def __init__(
        self,
        display: Callable[[], Display | None],
        add: Callable[[], object],
        **of_display: Callable[[Display], object],
    ) -> None:
        self._display = display
        """Returns the display that Duplicate, Remove and Rename are about."""
        self._add = add
        self._of_display = of_display
        self.chosen: int | None = None

    def all(self) -> list[Button]:
        """The buttons from the left (displays_panel.cpp)."""
        display = self._display()

        def on_display(name: str, letter: str) -> Button:
            act = self._of_display[name.lower()]
            return Button(name, letter, None if display is None else partial(act, display))

        return [
            Button("Add", "n", self._add),
            on_display("Duplicate", "d"),
            on_display("Remove", "x"),
            on_display("Rename", "r"),
        ]

    def move(self, steps: int) -> None:
        """Go to a button farther right, or left."""
        self.chosen = max(0, min(len(self.all()) - 1, (self.chosen or 0) + steps))

    def press(self) -> None:
        """Press the button that has the keyboard."""
        if self.chosen is not None and (press := self.all()[self.chosen].press) is not None:
            press()

    def press_at(self, x: int, width: int) -> None:
        """Press the button at a column of the row."""
        for button, place in zip(self.all(), self.places(width), strict=True):
            if place.first <= x < place.end and button.press is not None:
                button.press()

    def texts(self, width: int) -> list[str]:
        """What stands on the buttons of a row of `width` cells: the names, with air and with their keys if there is room."""
        buttons = self.all()
        for form in (" {name} ^{key} ", "{name} ^{key}", " {name} ", "{name}"):
            texts = [form.format(name=button.name, key=button.letter.upper()) for button in buttons]
            if sum(map(len, texts)) + len(texts) - 1 <= width:
                break
        return texts

    def places(self, width: int) -> list[Place]:
        """Where the buttons are in a row of `width` cells."""
        places, column = [], 0
        for text in self.texts(width):
            places.append(Place(column, column + len(text)))
            column += len(text) + 1
        return places

    def segments(self, width: int, look: Look, *, active: bool) -> list[Segment]:
        """The row; `active`: the panel has the keyboard."""
        colours = look.colours
        row: list[Segment] = []
        for index, (button, text) in enumerate(zip(self.all(), self.texts(width), strict=True)):
            style = colours.muted if button.press is None else colours.key
            if active and index == self.chosen:
                style = colours.choice
            row += [Segment(text, style), Segment(" ", colours.text)]
        return row[:-1]
