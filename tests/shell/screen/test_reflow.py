"""Another width wraps the text anew: nothing is lost, nothing doubles, and all of it comes back."""

from __future__ import annotations

import itertools
import re
from typing import Any

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from day6_core.shell.screen import text as text_module
from day6_core.shell.screen.reflow import Marker
from day6_core.shell.screen.rows import Folded, Row, Run, joined_runs, row_text, runs_of, without_end
from day6_core.shell.screen.screen import Screen

PROMPT = "student@day6:~$"

WORDS = ["a", "hello ", "word " * 5, "x" * 33, "z" * 130, "你好", "机器人操作系统", "a你b好", "温度" * 20, "  "]
MARKS = ["e\u0301", "x\u0323" * 9, "你\u0301"]
COLOURS = ["\x1b[31m", "\x1b[0m", "\x1b[1;44m", "\x1b[7m"]
plain = st.lists(st.sampled_from([*WORDS, *MARKS, "\r\n", "\r\n", "\r\n"]), max_size=40).map("".join)
coloured = st.lists(st.sampled_from([*WORDS, *MARKS, *COLOURS, "\r\n", "\r\n"]), max_size=40).map("".join)
sizes = st.tuples(st.integers(1, 12), st.integers(2, 90))


def rows(screen: Screen) -> list[Row]:
    """All rows, without the empty ones at the end."""
    found = [*screen.scrollback, *map(screen.row, range(screen.lines))]
    while found and not found[-1]:
        found.pop()
    return found


def lines(screen: Screen) -> list[Row]:
    """The lines of text, however they are wrapped."""
    found: list[Row] = []
    runs: list[Run] = []
    for row in rows(screen):
        runs += runs_of(row)
        if not isinstance(row, Folded):
            found.append(without_end(tuple(joined_runs(runs))))
            runs = []
    found.append(without_end(tuple(joined_runs(runs))))
    while found and not found[-1]:
        found.pop()
    return found


def texts(screen: Screen) -> list[str]:
    return [row_text(screen.row(y)) for y in range(screen.lines)]


@given(coloured, sizes, st.lists(sizes, min_size=1, max_size=5))
@settings(max_examples=300, deadline=None)
def test_any_sizes_in_between_keep_every_line_and_its_colours(text: str, size: Any, others: Any) -> None:
    screen = Screen(size[1], size[0])
    screen.feed(text)
    before = lines(screen)
    for other in [*others, size]:
        screen.resize(*other)
        assert lines(screen) == before
        assert 0 <= screen.cursor.y < screen.lines and 0 <= screen.cursor.x <= screen.columns
    screen.feed("END")
    assert row_text(lines(screen)[-1]).endswith("END")


@given(plain, sizes, sizes)
@settings(max_examples=300, deadline=None)
def test_the_rows_are_those_of_a_window_that_always_had_this_width(text: str, before: Any, after: Any) -> None:
    screen, fresh = Screen(before[1], before[0]), Screen(after[1], after[0])
    text = re.sub(" +(\r\n|$)", r"\1", text)  # nobody keeps blanks at the end of a line
    screen.feed(text)
    fresh.feed(text)
    screen.resize(*after)
    for made in (screen, fresh):
        made.feed("!\r\n#")
    assert [row_text(row) for row in rows(screen)] == [row_text(row) for row in rows(fresh)]
    assert [isinstance(row, Folded) for row in rows(screen)] == [isinstance(row, Folded) for row in rows(fresh)]


@given(coloured, sizes, st.tuples(st.integers(1, 12), st.integers(1, 90)), st.lists(sizes, max_size=4))
@settings(max_examples=200, deadline=None)
def test_wherever_the_cursor_is_no_line_is_lost(text: str, size: Any, place: Any, others: Any) -> None:
    screen = Screen(size[1], size[0])
    screen.feed(text + f"\x1b[{place[0]};{place[1]}H")
    before = [line for line in lines(screen) if line]
    for other in [*others, size]:
        screen.resize(*other)
    assert [line for line in lines(screen) if line] == before


@given(plain, st.lists(sizes, min_size=1, max_size=5), st.lists(st.sampled_from("abc"), max_size=12))
@settings(max_examples=200, deadline=None)
def test_what_was_cleared_never_comes_back_onto_the_screen(text: str, others: Any, after: Any) -> None:
    screen = Screen(20, 6)
    screen.feed(text.replace("a", "x") + "\x1b[H\x1b[2J" + "\r\n".join(after))
    for other in others:
        screen.resize(*other)
        assert set("".join(texts(screen))) <= set(after)
    screen.resize(24, 20)
    assert screen.text == "\n".join(after)


def test_a_line_that_was_erased_and_written_anew_does_not_go_on_in_the_next() -> None:
    screen = Screen(10, 5)
    screen.feed("0123456789abc\x1b[A\r\x1b[2Kshort")
    screen.resize(5, 40)
    assert texts(screen)[:2] == ["short", "abc"]


@pytest.mark.parametrize("sequence", ["\x1b[L", "\x1b[M", "\x1bM", "\x1b[2;4r\x1b[2;1H\x1bM", "\x1b[1;2r\x1b[2;1H\n"])
@pytest.mark.parametrize("y", [1, 2, 3])
def test_lines_that_are_torn_apart_are_not_joined(sequence: str, y: int) -> None:
    screen = Screen(4, 5)
    screen.feed(f"aaaaAA\r\nbbbbBB\r\ncc\x1b[{y};1H{sequence}")
    shown = [text for text in texts(screen) if text]
    pairs = {"aaaa": "AA", "bbbb": "BB"}
    whole = [text + pairs[text] for text, after in itertools.pairwise(shown) if pairs.get(text) == after]
    screen.resize(5, 40)
    joined = [text for text in texts(screen) if len(text) > 4]
    assert set(joined) <= set(whole)


def test_the_main_screen_is_wrapped_anew_when_a_full_screen_program_leaves_it() -> None:
    screen = Screen(20, 4)
    screen.feed("0123456789abcdefghij-more\r\n$ less\x1b[?1049h\x1b[Hfull screen program")
    screen.resize(4, 10)
    assert texts(screen)[0] == "full scree"
    screen.feed("\x1b[?1049l")
    assert [row_text(row) for row in rows(screen)] == ["0123456789", "abcdefghij", "-more", "$ less"]
    screen.feed("!")
    screen.resize(4, 40)
    assert screen.text == "0123456789abcdefghij-more\n$ less!"


def test_a_full_scrollback_survives_a_narrow_window(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(text_module, "SCROLLBACK", 50)
    screen = Screen(80, 5)
    screen.feed("".join(f"{number:079}\r\n" for number in range(200)))
    before = rows(screen)
    screen.resize(5, 11)
    screen.resize(5, 80)
    assert rows(screen) == before and len(before) == 54


def test_a_marker_stays_with_its_character() -> None:
    screen = Screen(10, 3)
    screen.feed("".join(f"line {number} has a * star\r\n" for number in range(5)))
    at = [(y, row_text(row).index("*")) for y, row in enumerate(rows(screen)) if "*" in row_text(row)][2]
    marker = Marker(*at)
    screen.markers.add(marker)
    for columns in (7, 40, 2, 10, 9):
        screen.resize(3, columns)
        row = row_text(rows(screen)[marker.line - screen.scrolled + len(screen.scrollback)])
        assert row[marker.column] == "*"
    screen.resize(3, 40)
    assert row_text(rows(screen)[marker.line]).startswith("line 2")


def test_a_saved_place_of_the_cursor_stays_with_its_character() -> None:
    screen = Screen(20, 6)
    screen.feed("a line that is longer than the window\r\nname: \x1b7\r\nmore")
    for lines_, columns in ((6, 10), (3, 10), (6, 40), (6, 20)):
        screen.resize(lines_, columns)
        before = screen.cursor.x, screen.cursor.y
        screen.feed("\x1b8")
        assert row_text(screen.row(screen.cursor.y)).startswith("name:") and screen.cursor.x == 6
        screen.feed(f"\x1b[{before[1] + 1};{before[0] + 1}H")


def test_what_a_full_screen_program_scrolled_away_is_no_history() -> None:
    screen = Screen(10, 2)
    screen.feed("$ less\x1b[?1049h" + "page\r\n" * 5 + "\x1b[?1049l")
    assert list(screen.scrollback) == [] and screen.text == "$ less"


# -- at the prompt -----------------------------------------------------------------------------------------------------


def whole(seat: Any) -> str:
    """Everything the terminal has, line by line."""
    seat.look()
    return "\n".join(map(row_text, lines(seat.terminal.screen)))


@pytest.mark.parametrize("typed", ["", "echo hi", "echo " + "x" * 100, "echo " + "温度" * 40, "x" * 64, "x" * 24])
@pytest.mark.parametrize("back", [0, 3, 30])
def test_a_line_at_the_prompt_stands_there_once_in_every_width(seat: Any, typed: str, back: int) -> None:
    seat.line("echo before; printf '%090d\\n' 7")
    seat.type(typed + "\x1b[D" * back)
    before = whole(seat)
    for columns, height in ((40, 24), (20, 12), (80, 24), (16, 24), (79, 20), (8, 24), (120, 30), (80, 24)):
        seat.terminal.resize(columns, height)
        seat.settle()
        assert whole(seat) == before
    seat.type("#\x05\x15")
    assert whole(seat) == before.removesuffix(typed).rstrip()


def test_what_runs_prints_on_below_what_was_wrapped(seat: Any) -> None:
    seat.line("sleep 1; printf '%0100d\\n' 5 6; sleep 1; printf '%0100d\\n' 7")
    seat.settle(1.5)
    seat.terminal.resize(30, 12)
    seat.settle(1)
    seat.terminal.resize(110, 24)
    seat.settle()
    assert seat.look().splitlines()[-4:] == ["0" * 99 + digit for digit in "567"] + [PROMPT]


def test_what_a_background_job_printed_stays_when_the_window_is_resized(seat: Any) -> None:
    seat.line("(sleep 1; printf 'one\\ntwo\\nthree') &")
    seat.type("echo " + "x" * 100)
    seat.settle(1.5)
    seat.terminal.resize(60, 24)
    seat.settle()
    assert {"two", "three"} <= set(whole(seat).splitlines())


def test_after_clear_a_window_that_comes_and_goes_leaves_the_screen_as_it_was(seat: Any) -> None:
    seat.line("seq 1 100")
    for clear in ("clear\r", "\x0c"):
        seat.type(clear + "seq 1 8\r")
        before = seat.look()
        assert before.splitlines()[-1] == PROMPT and "\n9" not in before
        for height in (6, 24, 3, 24, 12, 1, 24):
            seat.terminal.resize(80, height)
            seat.settle()
            assert seat.look().splitlines()[-1] == PROMPT
        assert seat.look() == before


def test_a_hidden_terminal_is_wrapped_when_it_is_looked_at_but_its_programs_know_at_once(seat: Any) -> None:
    seat.look()
    picture = seat.terminal.screen
    for columns in (70, 60, 50):
        seat.terminal.resize(columns, 20)
    assert picture.columns == 80 and seat.terminal.columns == 50
    assert seat.terminal.streams.stdout.columns == 50
    assert seat.terminal.screen.columns == 50
