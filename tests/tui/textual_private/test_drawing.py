"""What is sent to a slow line first, and that all of it is sent at last."""

from __future__ import annotations

import random

import pyte
from rich.color import ColorSystem
from rich.segment import Segment
from rich.style import Style
from textual.geometry import Offset, Region, Size
from textual.strip import Strip

from day6_tui.screen.line import LEAST_AHEAD
from day6_tui.textual_private.drawing import HEAD_START, Drawing, PreparedUpdate
from day6_tui.textual_private.frame_screen import SpansUpdate
from tests.support.folded import folded
from tests.tui.test_line import FakeTerminal, started

SIZE = Size(40, 12)
LEFT = Region(0, 0, 20, 12)
"""The widget with the keyboard."""
CURSOR = Offset(5, 7)
STYLES = [Style(color="red"), Style(bgcolor="blue"), Style(bold=True), None]


class Screen:
    """Two widgets side by side, of which parts are dirty, and the terminal at the end of the line."""

    def __init__(self, terminal: FakeTerminal) -> None:
        self.terminal = terminal
        self.drawing = Drawing(terminal.line, lambda: terminal.now)
        self.picture = pyte.Screen(*SIZE)
        self.stream = pyte.Stream(self.picture)
        self.texts = [["." * 20, "." * 20] for _ in range(SIZE.height)]
        self.styles = [[STYLES[0]] * 2 for _ in range(SIZE.height)]
        self.dirty: set[Region] = {SIZE.region}

    def write(self, y: int, side: int, text: str, style: Style | None = None) -> None:
        """Let a widget have another line."""
        self.texts[y][side], self.styles[y][side] = text.ljust(20), style
        self.dirty.add(Region(20 * side, y, 20, 1))

    def draw(self) -> PreparedUpdate:
        """Have sent what may be."""
        places = [(20 * side, y) for y in range(SIZE.height) for side in (0, 1)]
        strips = [
            (x, y, Strip([Segment(self.texts[y][x // 20], self.styles[y][x // 20])], 20))
            for x, y in places
            if any(region.overlaps(Region(x, y, 20, 1)) for region in self.dirty)
        ]
        update = SpansUpdate([], strips)
        prepared, left = self.drawing.prepare(update, SIZE, ColorSystem.TRUECOLOR, LEFT, CURSOR)
        self.dirty = set(left)
        text = prepared.render_segments(None)  # type: ignore[arg-type]
        self.terminal.write(len(text))
        if not self.terminal.line.waits:
            self.terminal.ask()
        self.stream.feed(text)
        return prepared

    def settle(self) -> None:
        """Have all of it sent."""
        for _ in range(100):
            self.draw()
            self.terminal.wait(1.0)
            if not self.dirty:
                return
        raise AssertionError("there is no end")

    def seen(self) -> list[str]:
        """The lines of the terminal."""
        return list(self.picture.display)

    def meant(self) -> list[str]:
        """The lines as they should be."""
        return ["".join(parts) for parts in self.texts]


def slow() -> Screen:
    """A screen at the end of a slow line, to which nothing is under way."""
    terminal = started(4_000)
    terminal.stream(3.0)
    terminal.wait(3.0)
    screen = Screen(terminal)
    screen.settle()
    return screen


def test_to_a_fast_terminal_everything_is_sent_at_once() -> None:
    screen = Screen(started(20e6))
    screen.draw()
    assert not screen.dirty and screen.seen() == screen.meant()


def test_the_cells_around_the_cursor_come_first_then_the_widget_with_the_keyboard() -> None:
    screen = slow()
    for y in range(SIZE.height):  # each of these lines takes 60 bytes and more
        for side in (0, 1):
            screen.write(y, side, "".join(random.Random(y * 2 + side).choices("abcdefgh", k=20)), STYLES[y % 3])
    first = screen.draw()
    assert first.spans[0][:2] == (CURSOR.y, 0)
    assert {x for _, x, _ in first.spans} == {0, 20} and screen.dirty
    rights = [number for number, (_, x, _) in enumerate(first.spans) if x == 20]
    assert min(rights) == 12, "first all of the left ones"


def test_a_key_is_echoed_though_the_line_is_full() -> None:
    screen = slow()
    screen.terminal.write(LEAST_AHEAD)
    screen.write(CURSOR.y, 0, "typed")
    screen.write(CURSOR.y, 1, "moving")
    prepared = screen.draw()
    assert "typed" in screen.seen()[CURSOR.y] and "moving" not in screen.seen()[CURSOR.y]
    assert [span[0] for span in prepared.spans] == [CURSOR.y] and screen.dirty


def test_what_waits_is_sent_as_it_is_by_then() -> None:
    screen = slow()
    screen.terminal.write(LEAST_AHEAD)
    for number in range(5):
        screen.write(2, 1, f"number {number}")
        assert not screen.draw().spans
    screen.terminal.wait(2.0)
    screen.draw()
    assert screen.seen() == screen.meant() and "number 4" in screen.seen()[2]


def test_what_always_changes_below_the_keyboard_does_not_keep_the_rest_waiting() -> None:
    screen = slow()
    screen.write(3, 1, "at last")
    began, picker = screen.terminal.now, random.Random(1)
    while "at last" not in screen.seen()[3]:
        for y in range(SIZE.height):
            screen.write(y, 0, "".join(picker.choices("abcdefgh", k=20)), STYLES[y % 3])
        screen.draw()
        screen.terminal.wait(1 / 30)
        assert screen.terminal.now - began < 4 * HEAD_START


@folded("seed", range(15))
def test_at_last_the_terminal_shows_everything_as_it_is(seed: int) -> None:
    picker = random.Random(seed)
    screen = slow()
    for _ in range(picker.randint(20, 80)):
        for _ in range(picker.randint(0, 8)):
            text = "".join(picker.choices("ab 海", k=picker.randint(1, 10)))
            cells = sum(2 if char == "海" else 1 for char in text)
            y, side = picker.randrange(SIZE.height), picker.randrange(2)
            screen.write(y, side, text, picker.choice(STYLES))
            screen.texts[y][side] = text + " " * (20 - cells)
        screen.draw()
        screen.terminal.wait(picker.choice((0.01, 0.1, 0.5)))
    screen.settle()
    plain = Screen(started(20e6))
    plain.texts, plain.styles = screen.texts, screen.styles
    plain.draw()
    assert screen.seen() == plain.seen()
    for y in range(SIZE.height):
        for x in range(SIZE.width):
            ours, theirs = screen.picture.buffer[y][x], plain.picture.buffer[y][x]
            assert (ours.data, ours.bg) == (theirs.data, theirs.bg), (x, y)
            assert ours.data == " " or (ours.fg, ours.bold) == (theirs.fg, theirs.bold), (x, y)
