"""Every budget of day6-tui, declared once, and the table in which figures stand beside them.

`bench.py` measures nearly all of them, `slow_line.py`, `hostile_machine.py` and `soak.py` the others; those of virtual time
`python -m tests.virtual.table`, `tests.grading.table` and `tests.lessons.table`. The budgets of
docs/*/trust/performance.md are these, in this order (tests/docs/test_budgets.py).
"""

from __future__ import annotations

from collections.abc import Iterable
from typing import NamedTuple


class Row(NamedTuple):
    """One line of a table of figures."""

    what: str
    measured: str
    budget: str = ""
    kept: bool = True


class Budget(NamedTuple):
    """What may be measured at most, or has to be at least."""

    what: str
    limit: float
    unit: str
    least: bool = False

    def keeps(self, value: float) -> bool:
        return value >= self.limit if self.least else value <= self.limit

    def row(self, value: float, more: str = "") -> Row:
        """What was measured beside the limit; `more` says it in other figures."""
        measured = f"{figure(value)} {self.unit}" + (f" ({more})" if more else "")
        return Row(self.what, measured, f"{'>=' if self.least else '<='} {self.limit:g} {self.unit}", self.keeps(value))


def figure(number: float) -> str:
    """Three digits that mean something."""
    return f"{number:.0f}" if abs(number) >= 100 else f"{number:.3g}"


def print_table(rows: Iterable[Row]) -> int:
    """Print the rows as Markdown, each when it comes, and below the table what isn't kept; return how many those are."""
    print("| what | measured | budget | kept |\n| --- | --- | --- | --- |")
    missed = []
    for row in rows:
        kept = ("yes" if row.kept else "**no**") if row.budget else ""
        print(f"| {row.what} | {row.measured} | {row.budget} | {kept} |", flush=True)
        if not row.kept:
            missed.append(row)
    print(f"\n{len(missed)} over budget" + "".join(f"\n- {row.what}: {row.measured}, {row.budget}" for row in missed))
    return len(missed)


FIRST_FRAME = Budget("first frame, 80x24: times a bare Textual app", 1.5, "×")
FIRST_MEMORY = Budget("memory at the first frame (RSS)", 48, "MB")
ROBOT_MEMORY = Budget("memory, robot shown and link open (PSS)", 75, "MB")
"""Of the 84 MB that are resident, 11 are code of Zenoh, mapped from a file: a machine holds them once for the desktop and every
program on the link. PSS divides such pages among those who have them, so the sum of all processes is what the machine needs; RSS
would count them again in each. Where no other process uses Zenoh, both are the same, and the scene always has some."""
WELCOME = Budget("CPU at the welcome screen", 0.5, "%")
STANDING = Budget("CPU, turtlesim standing still", 4, "%")
DRIVING = Budget("CPU, moving turtle, 120x40, dense", 12, "%")
FRAME = Budget("  a frame (30 a second)", 700, "bytes")
FOUR_STANDING = Budget("CPU, four panes (turtle, its node, teleop, echo), standing", 4, "%")
FOUR_DRIVING = Budget("CPU, four panes, driving: echo prints ten messages a second", 12, "%")
PIXELS = Budget("CPU, real pixels, turtle moving", 35, "%")
PIXEL_FRAME = Budget("  a frame", 40, "kB")
TURNING = Budget("CPU, turning robot in RViz, 120x40, 15 fps", 18, "%")
WORLD_STANDING = Budget("CPU, world, car standing still, 120x40", 10, "%")
WORLD_DRIVING = Budget("CPU, world, driving in circles", 14, "%")
LIDAR = Budget("CPU, world, driving, with the lidar drawn", 18, "%")
BESIDE = Budget("CPU of turning, lidar, panes: times another installation's", 0.67, "×")
"""With `--beside` the installation of commit ee266819."""
ECHO = Budget("key to echo, three runaways on the same core, median", 60, "ms")
ECHO_WORST = Budget("  worst", 200, "ms")
SLOW_PROMPT = Budget("4 kB/s: first prompt", 5, "s")
SLOW_KEY = Budget("4 kB/s: key to echo", 1, "s")
SLOW_END = Budget("4 kB/s: Ctrl-C in a flood, to the prompt", 0.5, "s")
FASTER_PROMPT = Budget("50 kB/s: first prompt", 5, "s")
FASTER_KEY = Budget("50 kB/s: key to echo", 0.15, "s")
FASTER_END = Budget("50 kB/s: Ctrl-C in a flood, to the prompt", 0.5, "s")
SCENE_START = Budget("what the start of a scene writes", 25, "kB")
PASTE = Budget("a paste of 1 MB at the prompt: shown after", 1, "s")
LINES = Budget("output that scrolls by, lines of 80", 10, "MB/s", least=True)
ONE_LINE = Budget("output that scrolls by, one line: times a bare reader", 0.5, "×", least=True)
CHINESE = Budget("output that scrolls by, Chinese", 10, "MB/s", least=True)
COLOURED = Budget("output that scrolls by, coloured", 3, "MB/s", least=True)
BINARY = Budget("output that scrolls by, binary", 2, "MB/s", least=True)
REFLOW = Budget("10,000 rows of scrollback wrapped for another width", 100, "ms")
FORGOTTEN = Budget("a hostile machine: forgotten after", 5, "s")
ENDED = Budget("a hostile machine: end of the desktop meanwhile", 2, "s")
GROWTH = Budget("a lesson beside programs that start and end: memory grows by", 1, "MB")
"""After the warm-up, comparing the medians of a tenth of the samples at either end."""
FIRST_MESSAGE = Budget("process joined, start to first message: times real rclpy", 0.25, "×")
JOINED_MEMORY = Budget("  its memory (RSS)", 38, "MB")
ALONE = Budget("process with a node, alone, start to end: times real rclpy", 0.33, "×")
ALONE_MEMORY = Budget("  its memory (RSS)", 24, "MB")
ACTION = Budget("action, goal to result: times faster than real rclpy", 5, "×", least=True)
TIMER = Budget("100 Hz timer misses its period by, 99th percentile: times real rclpy", 0.5, "×")
TOPIC_LIST = Budget("ros2 topic list, a process of its own", 0.15, "s")
TOPIC_LIST_REAL = Budget("  times the real one with its daemon", 0.33, "×")
TEN_MINUTES = Budget("virtual time: ten minutes of five programs, on one core", 5, "s")
NOBODY_WAITS = Budget("virtual time: CPU of a program that never waits, times that in real time", 1.1, "×")
SAME_RUNS = Budget("virtual time: runs of six processes beside busy loops that are the same", 1000, "", least=True)
GRADED = Budget("grade: 40 submissions of one day", 10, "s")
LESSONS = Budget("all lessons and drills played", 60, "s")
