"""Where the characters of a line stand on the screen, compared with a terminal that prints them."""

from __future__ import annotations

import random

import pytest

from day6_core.shell.line.layout import lay_out, near, shown
from day6_core.shell.screen.screen import Screen

ALPHABET = "aab 中é\n\x01\t"


def printed(text: str, columns: int) -> tuple[int, int]:
    """Row and column in which a terminal that printed the text would put the next character."""
    screen = Screen(columns, 200)
    screen.feed(shown(text).replace("\n", "\r\n"))
    row, column = screen.cursor.y, screen.cursor.x
    return (row + 1, 0) if column == columns else (row, column)


def test_the_cursor_stands_where_a_terminal_prints_the_next_character() -> None:
    chosen = random.Random(6)
    for _ in range(500):
        columns = chosen.randint(4, 12)
        text = "".join(chosen.choices(ALPHABET, k=chosen.randint(0, 40)))
        layout = lay_out(text, len(text), columns)
        assert (layout.row, layout.column) == printed(text, columns), (text, columns)
        assert layout.end_column == layout.column and len(layout.starts) == layout.row + 1


@pytest.mark.parametrize("text", ["abcdef", "ab中cdef", "ab\ncdefgh", "abcd\nef"])
def test_every_row_begins_where_the_layout_says(text: str) -> None:
    layout = lay_out(text, 0, 4)
    screen = Screen(4, 9)
    screen.feed(text.replace("\n", "\r\n"))
    rows = screen.text.split()
    ends = [*layout.starts[1:], len(text)]
    said = [text[start:end].strip("\n") for start, end in zip(layout.starts, ends, strict=True)]
    assert [row for row in said if row] == rows


def test_only_the_lines_around_the_cursor_are_looked_at() -> None:
    text = "\n".join(f"line {number}" for number in range(1000))
    at = text.index("line 500")
    start, end = near(text, at, 3)
    assert text[start:end] == "line 497\nline 498\nline 499\nline 500\nline 501\nline 502\nline 503\n"
    assert near("short", 2, 3) == (0, 5) and near("", 0, 3) == (0, 0)
