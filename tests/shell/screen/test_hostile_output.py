"""What programs write into an emulated terminal: it shows text, and its answers are the harmless standard ones."""

from __future__ import annotations

import re

import pytest

from day6_core.session.harmless import one_line
from day6_core.shell.screen.rows import cells_of
from day6_core.shell.screen.screen import Screen
from day6_core.shell.screen.vt import MOST_ANSWERS

STRANGE = "".join(
    map(chr, [*range(0x20), *range(0x7F, 0xA0), 0xAD, 0x61C, *range(0x2000, 0x2100), 0xDC80, 0xDFFF, 0xFEFF])
)
STRANGE += "\ufdd0\uffff\U000e0041\U0010eeee"
QUERIES = [
    "\x1b[c", "\x1b[0c", "\x1b[>c", "\x1b[=c", "\x1b[5n", "\x1b[6n", "\x1b[?6n", "\x1bZ", "\x05", "\x1b[21t", "\x1b[18t",
    "\x1bP$qm\x1b\\", "\x1bP+q544e\x1b\\", "\x1b]10;?\x07", "\x1b]4;1;?\x07", "\x1b]52;c;?\x07", "\x1b[>q",
    "\x1b[x", "\x1b[?2026$p", "\x1b[?u",
]  # fmt: skip
ANSWER = re.compile(r"(?:\x1b\[\?6c|\x1b\[0n|\x1b\[\d+;\d+R)*")


def everything_shown(screen: Screen) -> str:
    rows = [screen.history_row(index) for index in range(len(screen.scrollback))]
    rows += [screen.row(y) for y in range(screen.lines)]
    return "".join(cell.data for row in rows for cell in cells_of(row))


@pytest.mark.parametrize("between", ["", "a", "\x1b[31m", "\n"])
def test_no_cell_ever_holds_what_is_no_text(between: str) -> None:
    screen = Screen(20, 5)
    for char in STRANGE:
        screen.feed("x" + char + between)
        screen.feed("\x1b\\\x07\x18")  # the end of whatever began
    screen.feed(STRANGE)
    shown = everything_shown(screen)
    assert one_line(shown) == shown


def test_what_scrolls_by_in_one_go_is_looked_at_as_well() -> None:
    screen = Screen(20, 5)
    strange = "".join(char for char in STRANGE if ord(char) >= 0xA0)
    screen.feed("\r\n".join(f"x{char}y{strange}" for char in strange))
    assert len(screen.scrollback) > 5
    shown = everything_shown(screen)
    assert one_line(shown) == shown and "\ufffd" in shown


@pytest.mark.parametrize("query", QUERIES)
def test_answers_to_queries_carry_nothing_of_what_was_written(query: str) -> None:
    screen = Screen(20, 5)
    screen.feed("\x1b]0;rm -rf ~\r\x07\x1b]2;rm -rf ~\r\x07" + query + query)
    assert ANSWER.fullmatch("".join(screen.answers)), screen.answers


def test_a_file_full_of_queries_gets_few_answers() -> None:
    screen = Screen(20, 5)
    screen.feed("\x1b[6n" * 10_000)
    assert len(screen.answers) == MOST_ANSWERS


def test_marks_stay_on_their_characters_on_the_screen_and_above_it() -> None:
    text = "e\u0301 \u0939\u0941 小\u0301 \u0e01\u0e33"  # accent, Hindi, an accent on a wide character, Thai
    screen = Screen(20, 3)
    screen.feed(text)
    live = [cell.data for cell in cells_of(screen.row(0))]
    screen.feed("\r\n" * 5)
    assert [cell.data for cell in cells_of(screen.history_row(0))] == live
    assert live[0] == "\u00e9" and live[2] == "\u0939\u0941" and live[4] == "小\u0301"
