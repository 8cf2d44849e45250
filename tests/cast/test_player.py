"""The player without its terminal: the clock that pauses, jumps and has speeds, and what is sent to draw a picture."""

from __future__ import annotations

import os
import re

import pytest

pytest.importorskip("termios", reason="casts are played in terminals of Linux and macOS")

from day6_core.shell.screen.screen import Screen
from day6_tui.appearance.glyphs import is_colourless
from day6_tui.cast.file import Cast, CastEvent
from day6_tui.cast.film import Film
from day6_tui.cast.player import Clock, Painter
from day6_tui.panes.cells import cell_len

ALLOWED = re.compile(r"\x1b\[[0-9;]*[mHJK]")


def film(*events: tuple[float, str], size: tuple[int, int] = (20, 4)) -> Film:
    return Film(Cast(size, tuple(CastEvent(time, "o", text) for time, text in events)))


def test_time_goes_at_its_speed_stands_and_jumps() -> None:
    clock = Clock(100.0, 60.0)
    assert clock.seconds(104.0) == 4.0
    clock.change_speed(104.0, 1)
    assert (clock.speed, clock.seconds(105.0)) == (2.0, 6.0)
    clock.toggle(105.0)
    assert clock.seconds(500.0) == 6.0
    clock.jump(500.0, -10.0)
    assert clock.seconds(500.0) == 0.0
    clock.toggle(500.0)
    for _ in range(9):
        clock.change_speed(500.0, -1)
    assert (clock.speed, clock.seconds(504.0)) == (0.25, 1.0)
    assert clock.seconds(9000.0) == 60.0
    clock.toggle(9000.0)
    assert clock.seconds(9004.0) == 1.0, "from the beginning"


def test_only_rows_that_changed_are_sent_again() -> None:
    shown = film((0, "one\r\ntwo"), (1, "\x1b[2;1HTWO"))
    painter = Painter({})
    shown.go_to(0)
    assert "one" in painter.paint(shown, 20, 5, "status")
    shown.go_to(1)
    again = painter.paint(shown, 20, 5, "status")
    assert "TWO" in again and "one" not in again
    assert "one" in painter.paint(shown, 19, 5, "status"), "another size shows everything"


@pytest.mark.parametrize("columns", [1, 7, 20, 300])
@pytest.mark.parametrize("environ", [{}, {"COLORTERM": "truecolor"}, {"NO_COLOR": "1"}, {"TERM": "dumb"}])
def test_nothing_but_text_colours_and_places_is_sent(columns: int, environ: dict[str, str]) -> None:
    hostile = "\x1b]0;t\x07\x1b[?1000h\x1b[31;48;2;1;2;3;9m海龟\u202ex\x1b[0m\x00\x9b6n" + "\x1b[38;5;200mlong" * 9
    shown = film((0, hostile))
    shown.go_to(0)
    sent = Painter(environ).paint(shown, columns, 5, "status")
    rest = ALLOWED.sub("", sent)
    assert rest.isprintable()
    assert not is_colourless(environ) or "38;" not in sent
    screen = Screen(columns, 5)
    screen.feed(sent)
    assert all(cell_len(line) <= columns for line in screen.text.split("\n"))


def test_what_is_drawn_is_the_picture() -> None:
    text = "\x1b[1;3;4;7;9;31mred\x1b[0m \x1b[92mgreen \x1b[38;2;255;0;128mpink 海龟 \x1b[44mblue"
    shown = film((0, text), size=(40, 4))
    shown.go_to(0)
    screen = Screen(40, 5)
    screen.feed(Painter({"COLORTERM": "truecolor"}).paint(shown, 40, 5, "status"))
    assert [screen.row(y) for y in range(4)] == [shown._screen.row(y) for y in range(4)]
    assert os.linesep not in screen.text.split("\n")[0]
