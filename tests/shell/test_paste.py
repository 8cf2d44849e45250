"""What comes from the clipboard arrives whole, soon, and without stopping anybody else."""

from __future__ import annotations

import time
from typing import Any

import pytest

from day6_core.session.task import sleep_until
from day6_core.shell.line.discipline import MOST_TYPED_AHEAD

LINE = "echo this is line {}\n"
MEGABYTE = 1_000_000
LIMIT = 8.0
"""Seconds of this process's CPU for what takes about one; key by key it took hours."""


def lines(size: int) -> str:
    """So many characters of commands."""
    text = "".join(map(LINE.format, range(size // len(LINE))))
    return text[: size - 1] + "\n"


def test_four_hundred_lines_pasted_at_the_prompt_run_in_their_order(seat: Any) -> None:
    seat.terminal.paste("".join(f"echo {number} >> f.txt\n" for number in range(400)))
    seat.settle()
    assert seat.look().endswith("echo 399 >> f.txt") and not (seat.desk.home / "f.txt").exists()
    seat.line("", 1.0)
    assert (seat.desk.home / "f.txt").read_text().split() == [str(number) for number in range(400)]


@pytest.mark.parametrize("text", [lines(MEGABYTE), "x" * MEGABYTE, "\n" * MEGABYTE], ids=["lines", "one line", "Enter"])
def test_a_megabyte_pasted_at_the_prompt_is_there_within_seconds_and_can_be_edited(seat: Any, text: str) -> None:
    began = time.process_time()
    seat.terminal.paste(": '" + text)
    seat.settle()
    for key in ["a", "b", "\x7f", "\x1b[D", "\x1b[C", "c"]:
        seat.type(key)
    seat.terminal.send("' > /dev/null; echo $((6*7))\r")
    seat.settle()
    assert time.process_time() - began < LIMIT
    seat.settle(1.0)
    assert "42" in seat.look().split("\n")
    seat.type("\x1b[A")
    assert "echo $((6*7))" in seat.look()


def test_a_megabyte_pasted_into_cat_is_in_the_file(seat: Any) -> None:
    text = lines(MEGABYTE)
    began = time.process_time()
    seat.line("cat > big.txt")
    seat.terminal.paste(text)
    seat.type("\x04")
    assert time.process_time() - began < LIMIT
    seat.wait_prompt()
    assert (seat.desk.home / "big.txt").read_text() == text


def test_programs_keep_their_pace_while_a_long_text_is_pasted(machine: Any, seat: Any) -> None:
    scheduler, clock = machine.desk.scheduler, machine.desk.clock
    waiting: list[int] = []

    async def tick() -> None:
        for number in range(1, 31):
            await sleep_until(number * 10_000_000)
            waiting.append(len(seat.terminal._typed))

    seat.line("sleep 100")
    scheduler.spawn(tick())
    scheduler.advance()
    seat.terminal.paste(lines(MEGABYTE))
    clock.step(0.3)  # as after a moment in which nobody had the processor
    scheduler.advance()
    assert len(waiting) == 30 and waiting[0] > 0


def test_what_nobody_reads_is_kept_up_to_a_limit_and_beyond_it_the_terminal_beeps(seat: Any) -> None:
    seat.line("sleep 100")
    seat.terminal.send("x" * (MOST_TYPED_AHEAD + 100_000))
    beeps: list[str] = []
    write = seat.terminal.write
    seat.terminal.write = lambda text: beeps.append(text) if text == "\a" else write(text)
    seat.settle()
    kept = len(seat.terminal.discipline._line)
    assert MOST_TYPED_AHEAD <= kept < MOST_TYPED_AHEAD + 20_000 and beeps
    seat.terminal.write = write
    seat.type("\x03")


def test_a_megabyte_typed_ahead_without_marks_is_in_the_line_soon(seat: Any) -> None:
    seat.line("sleep 1")
    seat.terminal.send(": '" + "x" * MEGABYTE)
    began = time.process_time()
    seat.settle(1.0)
    seat.type("' && echo $((6*7))\r", 1.0)
    assert time.process_time() - began < LIMIT and "42" in seat.look().split("\n")


def test_a_paste_whose_end_comes_later_waits_for_it(seat: Any) -> None:
    seat.type("\x1b[200~echo a\recho b")
    assert "echo b" not in seat.look()
    seat.type("\r\x1b[20")
    seat.type("1~")
    assert seat.look().endswith("$ echo a\necho b")


def test_of_a_line_higher_than_the_window_the_rows_around_the_cursor_are_seen(seat: Any) -> None:
    seat.terminal.paste("\n".join(f"line {number}" for number in range(100)))
    seat.settle()
    assert seat.look().split("\n") == [f"line {number}" for number in range(76, 100)]
    seat.type("\x01")
    assert seat.look().split("\n")[0].endswith("$ line 0") and seat.look().split("\n")[-1] == "line 23"
    seat.type("X")
    assert seat.look().split("\n")[0].endswith("$ Xline 0")
    assert seat.terminal.screen.cursor.y == 0
