"""At the end of a slow line: keys are seen before the rest of the picture, and at last the picture is that of any other line."""

from __future__ import annotations

import random
import re
from collections.abc import Iterator
from contextlib import ExitStack, contextmanager
from pathlib import Path

import pytest

from tests.e2e.place import DAY6
from tests.support.short_folder import make_short_folder
from tests.support.slow_line import SlowLine
from tests.support.waiting import until

pytestmark = pytest.mark.person

PROMPT = "student@day6:~$"
SLOW, FAST = 4_000, 50e6
DEEDS = (
    ("F2",),
    ("F3",),
    ("Alt-1",),
    ("Alt-2",),
    ("F8",),
    ("F1",),
    (
        "\x1b[27u",
    ),  # Esc as newer terminals send it: an Esc alone and the next key, read late and together, are another key
    ("F7",),
    ("seq 40\r",),
    ("clear\r",),
    ("echo '海龟 走到 (5.5, 5.5)'\r",),
    ("printf '\\e[31mred \\e[7mreversed\\e[0m\\n'\r",),
    ("Up", "Enter"),
    ("abc", "Ctrl-U"),
)
"""What a person does with the desktop, whose outcome doesn't depend on when."""

MOST_AHEAD = 2_200
"""Bytes that may be on their way to the terminal when a key is pressed: a third of those of a whole screen."""


@contextmanager
def desktop(
    folder: Path, rate: float, columns: int = 80, rows: int = 24, *options: str, lang: str = "en", answers: bool = True
) -> Iterator[SlowLine]:
    """A desktop over such a line, with a home of its own."""
    (folder / "work").mkdir(parents=True)
    command = [*DAY6, "--home", str(folder / "home"), "--lang", lang, *(options or ("--scene", "empty"))]
    env: dict[str, str | None] = {"DAY6_LINK": "off", "DAY6_RUNTIME_DIR": str(make_short_folder("d6slow-"))}
    with SlowLine(command, columns, rows, cwd=folder / "work", env=env, rate=rate, answers=answers) as line:
        yield line


def _looks(line: SlowLine) -> list[tuple[str, ...]]:
    """Every cell: its text, colours and attributes, as far as they are seen."""
    cells = []
    for row in range(line.rows):
        for column in range(line.columns):
            cell = line._picture.buffer[row][column]
            plain = cell.data == " " and not (cell.reverse or cell.underscore or cell.strikethrough)
            front = (
                ""
                if plain
                else f"{cell.fg}{cell.bold}{cell.italics}{cell.underscore}{cell.reverse}{cell.strikethrough}"
            )
            cells.append((cell.data, cell.bg, front))
    return cells


@pytest.mark.parametrize(
    ("lang", "columns", "rows"), [("en", 80, 24), ("zh", 80, 24), ("en", 120, 40), ("zh", 120, 40)]
)
def test_the_picture_is_at_last_that_of_a_fast_line(tmp_path: Path, lang: str, columns: int, rows: int) -> None:
    picker = random.Random(f"{lang} {columns}")
    with ExitStack() as stack:
        lines = [
            stack.enter_context(desktop(tmp_path / str(rate), rate, columns, rows, lang=lang)) for rate in (SLOW, FAST)
        ]
        for line in lines:
            line.wait(PROMPT)
        for _ in range(25):
            deed = picker.choice(DEEDS)
            for line in lines:
                line.press(*deed)
            seconds = picker.choice((0.05, 0.3, 0.8))
            for line in lines:
                line.look(seconds / 2)
        slow, fast = lines

        def step() -> None:
            slow.look(0.02)
            fast.look(0.02)

        until(lambda: _looks(slow) == _looks(fast), every=0, meanwhile=step, told=lambda: _told(slow, fast))
        slow.settle()
        fast.settle()
        assert _looks(slow) == _looks(fast), _told(slow, fast)


def _told(slow: SlowLine, fast: SlowLine) -> str:
    pairs = zip(_looks(slow), _looks(fast), strict=True)
    unlike = [f"{n // slow.columns}:{n % slow.columns} {a} {b}" for n, (a, b) in enumerate(pairs) if a != b]
    return "\n".join([slow.look(), fast.look(), *unlike[:20]])


def test_a_key_in_a_new_terminal_comes_before_the_rest_of_the_picture(tmp_path: Path) -> None:
    with desktop(tmp_path, SLOW) as line:
        line.wait(PROMPT)
        line.settle()
        line.press("F2")
        until(lambda: line.waiting, every=0, meanwhile=lambda: line.look(0.005))
        line.press("x")
        assert line.waiting < MOST_AHEAD
        line.most_waiting = 0
        line.wait(lambda _: re.search(r"~\$ x", "\n".join(line.pane("2 ~"))))
        assert line.most_waiting < MOST_AHEAD


def test_a_flood_does_not_fill_the_line_ahead_of_keys(tmp_path: Path) -> None:
    with desktop(tmp_path, SLOW) as line:
        line.wait(PROMPT)
        line.line("yes 'a flood of words, of which each line is different' | cat -n")
        line.wait("flood of words, of which")
        line.settle(0.0)
        line.look(3)
        line.most_waiting = 0
        line.look(2)
        assert 0 < line.most_waiting < MOST_AHEAD
        line.press("Ctrl-C")
        line.wait(lambda _: any(piece.endswith("^C") for piece in line.pieces()))
        line.wait_lines(PROMPT)


def test_pictures_pause_for_the_line_and_go_on_with_it(tmp_path: Path) -> None:
    with desktop(tmp_path, SLOW, 80, 24, "--scene", "turtle") as line:
        line.wait("'q' to quit")
        line.settle()
        line.most_waiting = 0
        for _ in range(3):
            before = line.cells("TurtleSim")
            line.press("Up", "Left")
            line.look(1.5)
            assert line.cells("TurtleSim") != before
        assert line.most_waiting < MOST_AHEAD


def test_a_terminal_that_answers_nothing_is_not_waited_for(tmp_path: Path) -> None:
    with desktop(tmp_path, FAST, answers=False) as line:
        line.wait(PROMPT)
        line.press("F2")
        line.wait(lambda _: PROMPT in "\n".join(line.pane("2 ~")))
        line.line("seq 3000")
        line.wait("2999", "3000", PROMPT)
        assert line.output.count(b"\x1b[5n") < 40
        line.quit()
        assert line.wait_end() == 0


def test_ctrl_l_draws_what_another_program_has_written_over(tmp_path: Path) -> None:
    with desktop(tmp_path, FAST) as line:
        line.wait(PROMPT, "F2 ")
        line.settle()
        before = _looks(line)
        line._stream.feed(b"\x1b7\x1b[1;1H\x1b[2Jmessage from root\x1b8")
        line.send("\x0c")
        until(lambda: _looks(line) == before, every=0, meanwhile=lambda: line.look(0.02), told=line.look)
