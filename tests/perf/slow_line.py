"""Measures the desktop at the end of a slow line: how long a person waits for keys, the first prompt and Ctrl-C.

    python -m tests.perf.slow_line [--rates 4000 50000] [--size 80x24] [--lang en] [--python PYTHON]

The line takes so many bytes a second and hides a queue of 16 kB (`tests/support/slow_line.py`). Also measured: what the start of
each scene writes, over a line that hides nothing. Linux and macOS.
"""

from __future__ import annotations

import argparse
import math
import statistics
import sys
import tempfile
from collections.abc import Iterable, Iterator
from contextlib import contextmanager
from pathlib import Path

from tests.perf import budgets
from tests.perf.budgets import Budget, Row, print_table
from tests.perf.load import PUBLISH, TWIST, publish
from tests.support.slow_line import SlowLine

DAY6 = [sys.executable, "-m", "day6_tui.main"]
PROMPT = "student@day6:~$"
BUDGETS = {
    4_000.0: (budgets.SLOW_PROMPT, budgets.SLOW_KEY, budgets.SLOW_END),
    50_000.0: (budgets.FASTER_PROMPT, budgets.FASTER_KEY, budgets.FASTER_END),
}
"""Of the first prompt, of keys and of Ctrl-C, by the bytes a second."""
FAST = 50e6
LETTERS = "abcdefgh"
CAR = publish(TWIST, "/cmd_vel")
SCENES = {"empty": PROMPT, "turtle": "'q' to quit", "car": "wheel_spinner", "world": "currently:"}
"""What is on the screen when a scene has started."""


@contextmanager
def desktop(
    rate: float, columns: int = 80, rows: int = 24, *options: str, lang: str = "en", answers: bool = True
) -> Iterator[SlowLine]:
    """A desktop over such a line."""
    with tempfile.TemporaryDirectory(prefix="day6-slow-", ignore_cleanup_errors=True) as folder:
        command = [*DAY6, "--home", f"{folder}/home", "--lang", lang, *options]
        env: dict[str, str | None] = {"DAY6_LINK": "off", "DAY6_RUNTIME_DIR": folder}
        with SlowLine(command, columns, rows, cwd=Path(folder), env=env, rate=rate, answers=answers) as line:
            yield line


class Measured:
    """One rate and its budgets."""

    def __init__(self, rate: float, columns: int, rows: int, lang: str) -> None:
        self.rate, self.size, self.lang = rate, (columns, rows), lang
        self.prompt, self.key, self.end = BUDGETS[rate]

    def desktop(self, *options: str):  # type: ignore[no-untyped-def]  # what contextmanager makes
        return desktop(self.rate, *self.size, *options, lang=self.lang)

    def rows(self) -> Iterator[Row]:
        """All that is measured."""
        for part in (self.prompt_and_terminal, self.flood, self.turtle, self.world):
            try:
                yield from part()
            except AssertionError as error:
                yield self.key.row(math.inf, f"{part.__name__}: {str(error).splitlines()[0]}")

    def prompt_and_terminal(self) -> Iterator[Row]:
        """The first prompt, then F2 and a key."""
        with self.desktop("--scene", "empty") as line:
            yield self.prompt.row(line.seconds_until(lambda: line.find(PROMPT)))
            line.settle(0.5)
            began = line.written
            line.press("F2")
            line.look(0.2)
            line.press("x")
            took = line.seconds_until(lambda: line.find(f"{PROMPT} x", "2 ~"))
            line.settle(0.5)
            yield self.key.row(took, f"after F2; {line.written - began} bytes until all is drawn")
            line.press("Ctrl-U")
            line.settle(0.5)
            yield self.worst(self.key, self.echoes(line, 4), "at rest")

    def flood(self) -> Iterator[Row]:
        """Ctrl-C while `yes` prints."""
        with self.desktop("--scene", "empty") as line:
            line.seconds_until(lambda: line.find(PROMPT))
            line.line("yes")
            line.look(4)
            times = []
            for _ in range(3):
                line.press("Ctrl-C")
                times.append(line.seconds_until(lambda: line.find("^C") and line.find(PROMPT)))
                line.settle(0.5)
                line.line("clear; yes")
                line.look(4)
            yield self.worst(self.end, times)

    def turtle(self) -> Iterator[Row]:
        """An arrow in teleop; then keys at a prompt while the turtle moves."""
        with self.desktop("--scene", "turtle") as line:
            line.seconds_until(lambda: line.find("'q' to quit"))
            line.settle(1.5)
            times = []
            for key in ("Up", "Left", "Up"):
                seen = line.cells("TurtleSim")
                line.press(key)
                times.append(line.seconds_until(lambda seen=seen: line.cells("TurtleSim") != seen))  # type: ignore[misc]
                line.settle(1.5)
            yield self.worst(self.key, times, "an arrow in teleop, to the turtle's first step")
            line.press("F2")
            line.seconds_until(lambda: line.find(PROMPT, "5 ~"))
            line.line(f"{PUBLISH} &")
            line.look(3)
            yield self.worst(self.key, self.echoes(line), "while the turtle moves")

    def world(self) -> Iterator[Row]:
        """Keys at a prompt while the car drives."""
        with self.desktop("--scene", "world") as line:
            line.look(12)
            line.press("F2")
            line.look(3)
            line.line(f"{CAR} &")
            line.look(4)
            yield self.worst(self.key, self.echoes(line), "while the car drives")

    def echoes(self, line: SlowLine, count: int = len(LETTERS)) -> list[float]:
        """Type letters at the prompt, one after the other."""
        times, typed = [], ""
        for letter in LETTERS[:count]:
            typed += letter
            line.send(letter)
            times.append(line.seconds_until(lambda typed=typed: line.find(f"$ {typed}")))  # type: ignore[misc]
            line.look(0.3)
        line.press("Ctrl-U")
        return times

    @staticmethod
    def worst(budget: Budget, times: list[float], when: str = "") -> Row:
        """The worst of some times has to keep the budget."""
        return budget.row(max(times), f"{when + ', ' if when else ''}median {statistics.median(times):.2f} s")


def scenes(columns: int, rows: int, lang: str) -> Iterator[Row]:
    """What the start of each scene writes."""
    for scene, last in SCENES.items():
        with desktop(FAST, columns, rows, "--scene", scene, lang=lang) as line:
            line.seconds_until(lambda last=last: line.find(last))  # type: ignore[misc]
            yield budgets.SCENE_START.row(line.written / 1000, f"{scene}, {columns}x{rows}")


def slow_lines(
    rates: Iterable[float] = BUDGETS, columns: int = 80, rows: int = 24, lang: str = "en", *, lines: bool = True
) -> Iterator[Row]:
    """All rows: at these rates and in this size, then what scenes write."""
    for rate in rates if lines else ():
        yield from Measured(rate, columns, rows, lang).rows()
    for size in ((80, 24), (120, 40)):
        yield from scenes(*size, lang)


def main() -> int:
    """Print the table."""
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--rates", type=float, nargs="*", default=list(BUDGETS), choices=BUDGETS)
    parser.add_argument("--size", default="80x24")
    parser.add_argument("--lang", default="en")
    parser.add_argument("--scenes", action="store_true", help="only what scenes write, at 80x24 and 120x40")
    parser.add_argument("--python", default=sys.executable, help="the interpreter of another installation")
    options = parser.parse_args()
    DAY6[0] = options.python
    columns, rows = map(int, options.size.split("x"))
    return int(print_table(slow_lines(options.rates, columns, rows, options.lang, lines=not options.scenes)) > 0)


if __name__ == "__main__":
    sys.exit(main())
