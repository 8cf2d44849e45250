"""Commands as pupils really type them: `typed_ways.yaml` says which ways count for a step, and which only look like it.

The shell is the real one, in one process and on a stepped clock; only the checks about commands are asked.
"""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path
from typing import Any

import pytest
import yaml

from day6_core.lessons.catalogue import HERE
from day6_core.lessons.checks import Condition
from day6_core.lessons.document import Step
from day6_core.lessons.live import Live
from day6_core.lessons.reading import read_lesson
from tests.shell.conftest import Machine, Seat
from tests.support.waiting import until

WAYS = yaml.safe_load(Path(__file__).with_name("typed_ways.yaml").read_text(encoding="utf-8"))
ABOUT_COMMANDS = frozenset({"command", "visited", "ran"})
LASTS = 3.0
"""Seconds that a way has until Ctrl-C comes."""


def step_of(where: str) -> Step:
    """The step of a shipped lesson (`day1/look`) or the one of a drill (`17/yaml`)."""
    file, _, name = where.partition("/")
    path = next(each for each in HERE.glob("d*/*.md") if each.stem == file or each.name.startswith(f"{file}_"))
    return next(each for each in read_lesson(path).steps if each.name == name)


def about_commands(step: Step) -> list[Condition]:
    """The checks of a step that are about commands that were run, and about nothing else."""
    return [check for check in step.checks if {each.name for each in check.every() if not each.parts} <= ABOUT_COMMANDS]


def is_counted(
    machine: Machine, checks: list[Condition], lines: str, wait: Callable[[], object] = lambda: None
) -> bool:
    """Type a way in a terminal of its own, and ask the checks all the time.

    `wait` gives time of the wall to what works in a thread, as find does; within the tests threads need none.
    """
    machine.go(1.0)
    live = Live(machine.desk, None, machine.desk.home)
    seat = Seat(machine.desk)

    def solved() -> bool:
        verdicts = [check.judge(live) for check in checks]  # each is asked every time: what it has seen stays seen
        return all(verdict.ok for verdict in verdicts)

    found = False
    for line in lines.rstrip("\n").split("\n"):
        seat.line(line)
        for _ in range(int(LASTS / 0.25)):
            found = solved() or found
            if seat.terminal.idle:
                break
            seat.settle(0.25)
            wait()
        if not seat.terminal.idle:
            seat.type("\x03", 0.5)
            if seat.terminal.reading_keys:
                seat.type("q")
            until(lambda: seat.settle(0.25) or seat.terminal.idle, every=0.0, told=seat.look)
    found = solved() or found
    seat.terminal.close()
    return found


def played(where: str, home: Path, wait: Callable[[], object] = lambda: None) -> dict[str, bool]:
    """Each way of a step, and whether it counts."""
    ways: dict[str, Any] = WAYS[where]
    checks = about_commands(step_of(where))
    assert checks
    machine = Machine(home)
    try:
        if "before" in ways:
            behind = Seat(machine.desk)
            for line in ways["before"].strip().split("\n"):
                behind.line(line, 1.0)
        return {way: is_counted(machine, checks, way, wait) for way in (*ways["right"], *ways["cheats"])}
    finally:
        machine.desk.close()


@pytest.mark.parametrize("where", WAYS)
def test_what_was_done_counts_and_what_only_looks_so_does_not(where: str, tmp_path: Path) -> None:
    ways, found = WAYS[where], played(where, tmp_path / "home")
    assert [way for way in ways["right"] if not found[way]] == [], "right, and refused"
    assert [way for way in ways["cheats"] if found[way]] == [], "a cheat, and counted"


def test_every_step_here_has_three_ways_and_three_cheats() -> None:
    assert [where for where, ways in WAYS.items() if len(ways["right"]) < 3 or len(ways["cheats"]) < 3] == []
