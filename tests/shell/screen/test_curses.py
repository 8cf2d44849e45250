"""What full-screen programs send because TERM says xterm: line drawing, repeated characters, scrolled regions."""

from __future__ import annotations

import sys
from typing import Any

import pytest

from day6_core.shell.screen.screen import Screen

BOX = """\
import curses

def main(screen):
    curses.curs_set(0)
    window = curses.newwin(5, 30, 1, 2)
    window.box()
    window.addstr(1, 1, 'inside')
    window.addstr(2, 1, '=' * 28)
    window.refresh()
    window.getch()

curses.wrapper(main)
"""


def shown(text: str, columns: int = 20, lines: int = 5) -> list[str]:
    screen = Screen(columns, lines)
    screen.feed(text)
    return screen.text.split("\n")


def test_the_letters_of_line_drawing_are_lines() -> None:
    box = "\x1b(0lqqk\x1b(B\r\n\x1b(0x\x1b(Bqx\x1b(0x\x1b(B\r\n\x1b(0mqqj\x1b(B lqk"
    assert shown(box) == ["┌──┐", "│qx│", "└──┘ lqk"]
    assert shown("\r\n" * 9 + box)[-3:] == ["┌──┐", "│qx│", "└──┘ lqk"]


def test_whole_lines_of_line_drawing_that_scroll_by_are_lines() -> None:
    assert shown("\x1b(0" + "qqq\r\n" * 9)[-1] == "───"


def test_the_terminal_that_is_reset_draws_letters_again() -> None:
    assert shown("\x1b(0\x1bclqk") == ["lqk"]


@pytest.mark.parametrize(
    ("text", "lines"),
    [
        ("ab\x1b[3bc", ["abbbbc"]),  # REP
        ("\x1b[3b.", ["."]),
        ("\x1b(0q\x1b[4b", ["─────"]),
        ("1\r\n2\r\n3\r\n4\r\n5\x1b[2S!", ["3", "4", "5", "", " !"]),  # SU
        ("1\r\n2\r\n3\r\n4\r\n5\x1b[H\x1b[T!", ["!", "1", "2", "3", "4"]),  # SD
        ("1\r\n2\r\n3\r\n4\r\n5\x1b[2;4r\x1b[S", ["1", "3", "4", "", "5"]),  # DECSTBM
        ("1\r\n2\r\n3\r\n4\r\n5\x1b[2;4r\x1b[9T", ["1", "", "", "", "5"]),
        ("a\x1b[2Ib\x1b[Zc\x1b[9Zd", ["d               c"]),  # CHT, CBT
        ("\x1b[2;3H\x1b[s\x1b[Hx\x1b[uy", ["x", "  y"]),
        ("\x1b[5`x", ["    x"]),
    ],
)
def test_sequences_of_ncurses_do_what_xterm_does(text: str, lines: list[str]) -> None:
    assert shown(text) == lines
    screen = Screen(20, 5)
    for char in text:
        screen.feed(char)
    assert screen.text.split("\n") == lines


@pytest.mark.process
@pytest.mark.skipif(sys.platform == "win32", reason="there are no ptys")
@pytest.mark.parametrize("unicode", ["0", "1"])
def test_a_box_of_curses_is_a_box(seat: Any, unicode: str) -> None:
    (seat.desk.home / "box.py").write_text(BOX)
    seat.line(f"export NCURSES_NO_UTF8_ACS={unicode} TERM=xterm-256color")
    seat.terminal.run_line("python3 box.py")
    seat.wait(lambda text: "inside" in text and "┘" in text)
    rows = [row for row in seat.terminal.screen.text.split("\n") if row]
    assert rows[:5] == [
        f"  ┌{'─' * 28}┐",
        f"  │inside{' ' * 22}│",
        f"  │{'=' * 28}│",
        f"  │{' ' * 28}│",
        f"  └{'─' * 28}┘",
    ]
    seat.terminal.send("x")
    seat.wait(lambda text: "┘" not in text)


@pytest.mark.parametrize(
    ("sequence", "painted"),
    [
        ("\x1b[2J", [range(10)] * 4),
        ("\x1b[2;4H\x1b[J", [range(0), range(3, 10), range(10), range(10)]),
        ("\x1b[2;4H\x1b[1J", [range(10), range(4), range(0), range(0)]),
        ("\x1b[2;4H\x1b[K", [range(0), range(3, 10), range(0), range(0)]),
        ("\x1b[2;4H\x1b[3X", [range(0), range(3, 6), range(0), range(0)]),
    ],
)
def test_what_is_erased_has_the_colour_of_the_background_and_no_other_attribute(
    sequence: str, painted: list[range]
) -> None:
    screen = Screen(10, 4)
    screen.feed("ab\r\n中文c\x1b[1;4;7;31;44m" + sequence)
    cells = [[screen.buffer[y].get(x, screen.blank) for x in range(10)] for y in range(4)]
    assert [[x for x in range(10) if row[x].bg == "blue"] for row in cells] == [list(each) for each in painted]
    erased = {cell for row in cells for cell in row if cell.bg == "blue"}
    assert erased == {screen.blank._replace(bg="blue")}
