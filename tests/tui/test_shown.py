"""Only what differs is written, and then the terminal shows the same as if everything had been."""

from __future__ import annotations

import random
import re

import pyte
import pytest

from day6_tui.screen.shown import Shown, change
from tests.support.folded import folded

WIDTH, HEIGHT = 30, 5
LOOKS = [
    "",
    "1;38;2;255;0;0;48;2;9;9;9",
    "38;2;255;0;0;48;2;9;9;9",
    "31",
    "7;31;44",
    "4",
    "38;5;3;48;5;4",
    "1;3;97;104",
    "39;49",
]
TEXTS = ["a", " ", "海", "龟", "é", "─", "x y", "    ", " " * 20, "🐢"]


def segments(picker: random.Random, width: int) -> list[tuple[str, str]]:
    """A piece of a line of this width."""
    found, left = [], width
    while left:
        text = picker.choice(TEXTS)
        size = sum(2 if char in "海龟🐢" else 1 for char in text)
        if size <= left:
            found.append((text * (picker.randint(1, left // size)), picker.choice(LOOKS)))
            left -= size * (len(found[-1][0]) // len(text))
    return found


class Seen:
    """What a terminal shows of what is written."""

    def __init__(self) -> None:
        self.screen = pyte.Screen(WIDTH, HEIGHT)
        self.stream = pyte.Stream(self.screen)

    def cells(self) -> list[list[tuple[object, ...]]]:
        """Every cell as it is seen: of a blank, only the background and what is drawn on blanks."""
        return [[self._cell(self.screen.buffer[y][x]) for x in range(WIDTH)] for y in range(HEIGHT)]

    @staticmethod
    def _cell(cell: pyte.screens.Char) -> tuple[object, ...]:
        blank = cell.data == " " and not cell.reverse and not cell.underscore
        return cell.data, cell.bg, *(() if blank else (cell.fg, cell.bold, cell.italics, cell.underscore, cell.reverse))


def written(pieces: list[tuple[int, int, list[tuple[str, str]]]]) -> str:
    """All of it, as plainly as can be."""
    return "".join(
        f"\x1b[{y + 1};{x + 1}H" + "".join(f"\x1b[0;{look}m{text}" if look else f"\x1b[m{text}" for text, look in piece)
        for x, y, piece in pieces
    )


@folded("seed", range(40))
def test_the_terminal_shows_what_it_would_if_everything_had_been_written(seed: int) -> None:
    picker = random.Random(seed)
    shown, ours, theirs = Shown(), Seen(), Seen()
    shown.begin(erases=bool(seed % 2))
    for _ in range(12):
        y, cut = picker.randrange(HEIGHT), picker.randint(1, WIDTH - 1)
        pieces = [(0, y, segments(picker, cut)), (cut, y, segments(picker, WIDTH - cut))]
        theirs.stream.feed(written(pieces))
        picker.shuffle(pieces)
        brush = shown.brush(WIDTH, HEIGHT)
        for x, line, piece in pieces:
            brush.draw(x, line, piece)
        ours.stream.feed(brush.text())
        assert brush.hurt() == []
        assert ours.cells() == theirs.cells()


def test_nothing_is_written_twice() -> None:
    shown = Shown()
    for text in ("A day with 海龟 in the sun", "A day with 海龟 in the sea"):
        brush = shown.brush(WIDTH, HEIGHT)
        brush.draw(0, 0, [(text, "31")])
    assert brush.text() == "\x1b[1;25Hea" and brush.drawn == [(0, 24, 26)]
    brush = shown.brush(WIDTH, HEIGHT)
    brush.draw(0, 0, [("A day with ", "31"), ("海龟 in the sea", "31")])
    assert brush.text() == "" and brush.size == 0 and brush.drawn == []


def test_what_was_forgotten_is_written_again() -> None:
    shown = Shown()
    for forget in (shown.forget, lambda: shown.brush(WIDTH + 1, HEIGHT), lambda: shown.brush(WIDTH, HEIGHT + 1)):
        texts = []
        for _ in range(2):
            brush = shown.brush(WIDTH, HEIGHT)
            brush.draw(0, 0, [("abc", "")])
            texts.append(brush.text())
        assert texts[1] == ""
        forget()
        brush = shown.brush(WIDTH, HEIGHT)
        brush.draw(0, 0, [("abc", "")])
        assert "abc" in brush.text()


def test_colours_last_from_one_update_to_the_next_until_nothing_is_known() -> None:
    shown = Shown()
    texts = []
    for column, look in ((0, "31"), (1, "31"), (2, "32"), (3, "")):
        if column == 2:
            shown.forget()
        brush = shown.brush(WIDTH, HEIGHT)
        brush.draw(column, 0, [("x", look)])
        texts.append(brush.text().partition("H")[2])
    assert texts == ["\x1b[31mx", "x", "\x1b[0;32mx", "\x1b[mx"]


def test_half_of_a_wide_character_is_written_again_with_its_neighbour() -> None:
    shown = Shown()
    brush = shown.brush(WIDTH, HEIGHT)
    brush.draw(0, 0, [("海龟", "")])
    brush = shown.brush(WIDTH, HEIGHT)
    brush.draw(1, 0, [("x", "")])
    assert brush.hurt() == [(0, 0, 1)], "the terminal has erased the other half"
    brush.draw(0, 0, [(" ", "")])
    assert brush.hurt() == []


def test_blanks_take_whatever_colour_is_at_hand() -> None:
    brush = Shown().brush(WIDTH, HEIGHT)
    ground = "48;2;9;9;9"
    brush.draw(0, 0, [("a", f"31;{ground}"), ("    ", f"1;32;{ground}"), ("b", f"31;{ground}")])
    assert brush.text() == f"\x1b[1;1H\x1b[31;{ground}ma    b"


@pytest.mark.parametrize("old", LOOKS)
@pytest.mark.parametrize("new", LOOKS)
def test_a_change_of_colours_leads_to_the_new_ones_and_is_never_longer(old: str, new: str) -> None:
    ours, theirs = Seen(), Seen()
    ours.stream.feed(f"\x1b[0;{old}m" if old else "")
    ours.stream.feed(f"{change(old, new)}x")
    theirs.stream.feed(f"\x1b[0;{new}mx" if new else "x")
    assert ours.cells() == theirs.cells()
    assert len(change(old, new)) <= len(f"\x1b[0;{new}m")
    assert re.fullmatch(r"(\x1b\[[0-9;]*m)?", change(old, new))
