"""Whatever is typed or printed, the shell and the screen answer and go on."""

from __future__ import annotations

from typing import Any

import pytest
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st

from day6_core.shell.language.parser import parse
from day6_core.shell.language.words import SyntaxProblem
from day6_core.shell.screen.rows import row_text
from day6_core.shell.screen.screen import Screen
from day6_core.width import text_width

SHELL_PIECES = st.sampled_from(
    [
        "echo",
        " ",
        "a",
        "'",
        '"',
        "$",
        "${",
        "}",
        "$(",
        ")",
        "(",
        "|",
        "&",
        ";",
        "\n",
        ">",
        "<",
        "<<E",
        "2",
        "if",
        "then",
        "fi",
        "for",
        "case",
        "in",
        "esac",
        ";;",
        "[[ ",
        " ]]",
        " == ",
        " =~ ",
        "((",
        "))",
        "f() ",
        "function ",
        "local ",
        "x=",
        "${x/",
        "${x:",
        "$'",
        "!",
        "do",
        "done",
        "{",
        "`",
        "\\",
        "#",
        "=",
        "x=",
        "$((",
        "))",
        "*",
        "~",
        "while",
        "你",
        "&&",
        "||",
        "!",
        ">&",
        "<<<",
    ]
)

VT_PIECES = st.sampled_from(
    [
        "\x1b",
        "[",
        "]",
        "?",
        ";",
        "1",
        "25",
        "999",
        "m",
        "H",
        "J",
        "K",
        "A",
        "B",
        "C",
        "D",
        "r",
        "h",
        "l",
        "P",
        "@",
        "L",
        "M",
        "S",
        "T",
        "\r",
        "\n",
        "\t",
        "\b",
        "\a",
        "abc",
        "你好",
        "e\u0301",
        "\x1b[?1049h",
        "\x1b[?1049l",
        "\x1b[3;5r",
        "\x1b(0",
        "\x1b]0;t\x07",
        "\x1b[38;5;1m",
        "\x1b[38;2;1;2;3m",
        "\x9b",
        "\x1b[>c",
        "\x1b[6n",
        "\x1bM",
        "\x1bD",
        "\x1bc",
        "\x0e",
        "\x0f",
        "x" * 90,
    ]
)


@given(st.lists(SHELL_PIECES, max_size=20).map("".join))
@settings(max_examples=500, deadline=None)
def test_every_line_is_understood_or_told_to_be_wrong(source: str) -> None:
    try:
        parse(source)
    except SyntaxProblem as problem:
        assert str(problem)


@given(st.lists(SHELL_PIECES, max_size=12).map("".join))
@settings(max_examples=60, deadline=None, suppress_health_check=[HealthCheck.function_scoped_fixture])
def test_no_line_ends_the_shell_with_an_exception(machine: Any, source: str) -> None:
    if "while" in source or "for" in source:
        return
    program = machine.start(source)
    machine.go(1)
    program.kill()
    machine.go()
    assert "Error" not in machine.err.text
    assert machine.run("echo alive").out == "alive\n"


@given(st.lists(VT_PIECES, max_size=40), st.integers(1, 100), st.integers(1, 40))
@settings(max_examples=400, deadline=None)
def test_no_output_breaks_the_screen(pieces: list[str], columns: int, lines: int) -> None:
    screen = Screen(80, 24)
    for index, piece in enumerate(pieces):
        screen.feed(piece)
        if index == len(pieces) // 2:
            screen.resize(lines, columns)
    assert 0 <= screen.cursor.y < screen.lines
    assert 0 <= screen.cursor.x <= screen.columns
    assert all(y < screen.lines for y in screen.dirty)
    for y in range(screen.lines):
        assert text_width(row_text(screen.row(y))) <= max(screen.columns, 2)
    screen.feed("\x18\x1b\\\x1bc\x1b[?1049lalive")
    assert screen.text.endswith("e")


@pytest.mark.parametrize("width", [2, 10, 80])
def test_plain_text_looks_the_same_fast_and_slow(width: int) -> None:
    text = "".join(f"line {number} 你好 {'x' * (number % 13)}\r\n" for number in range(300)) + "tab\there\rT\r\nend"
    fast, slow = Screen(width, 12), Screen(width, 12)
    fast.feed(text)
    for char in text:
        slow.feed(char)
    assert fast.text == slow.text
    assert [row_text(row) for row in fast.scrollback] == [row_text(row) for row in slow.scrollback]
    assert (fast.cursor.x, fast.cursor.y) == (slow.cursor.x, slow.cursor.y)


def test_a_wide_character_that_does_not_fit_goes_to_the_next_line() -> None:
    screen = Screen(5, 3)
    screen.feed("abcd你e")
    assert screen.text == "abcd\n你e"
    assert screen.buffer[1][1].data == ""


def test_overwriting_half_of_a_wide_character_removes_the_other_half() -> None:
    screen = Screen(10, 3)
    screen.feed("你好\rx")
    assert screen.text == "x 好"
    screen.feed("\x1b[1;4Hy")
    assert screen.text == "x  y"


def test_a_full_screen_program_leaves_the_screen_as_it_was() -> None:
    screen = Screen(20, 4)
    screen.feed("before\r\n$ vi\r\n")
    screen.feed("\x1b[?1049h\x1b[2J\x1b[Hfull screen" + "\r\nmore" * 10)
    assert "full screen" not in "".join(map(row_text, screen.scrollback))
    assert screen.alternate
    screen.feed("\x1b[?1049l$ ")
    assert screen.text == "before\n$ vi\n$"


def test_colours_are_kept_in_runs() -> None:
    screen = Screen(40, 3)
    screen.feed("plain \x1b[1;31mred\x1b[0m \x1b[38;2;10;20;30mrgb\x1b[0m")
    runs = screen.row(0)
    assert [(text, style.fg, style.bold) for text, style in runs] == [
        ("plain ", "default", False),
        ("red", "red", True),
        (" ", "default", False),
        ("rgb", "0a141e", False),
    ]


def test_the_terminal_answers_a_programs_question_for_the_cursor() -> None:
    screen = Screen(40, 3)
    screen.feed("ab\x1b[6n")
    assert screen.answers == ["\x1b[1;3R"]
