"""Every shipped lesson and drill, played: each step begins unsolved, refuses its wrong answers, is solved by its solution.

`python -m tests.lessons.table` plays them by hand, several times if you like, and says how long it took.
"""

from __future__ import annotations

import subprocess
import sys
from collections.abc import Sequence
from pathlib import Path

import pytest

from day6_core.lessons.catalogue import HERE
from day6_core.lessons.reading import read_lesson
from tests.support.waiting import run

TOGETHER = 8
"""As many short files are given to one command."""

LONGEST = 400.0
"""Seconds of a core for one command."""

DAYS = sorted((HERE / "days").glob("*.md"))
DRILLS = sorted((HERE / "drills").glob("*.md"))
SHORT = [HERE / "example.md", HERE / "example_drill.md", *DRILLS]
GROUPS = [[path] for path in DAYS] + [SHORT[begin : begin + TOGETHER] for begin in range(0, len(SHORT), TOGETHER)]


def play(paths: Sequence[Path], *options: str) -> subprocess.CompletedProcess[str]:
    """Play lesson files as their author would."""
    command = [sys.executable, "-m", "day6_tui.main", "lessons", "play", *options, *map(str, paths)]
    done: subprocess.CompletedProcess[str] = run(command, None, LONGEST)
    return done


@pytest.mark.process
@pytest.mark.parametrize("paths", GROUPS, ids=lambda paths: paths[0].stem)
def test_they_are_solved_by_their_solutions_alone(paths: Sequence[Path]) -> None:
    done = play(paths)
    assert (done.returncode, done.stderr) == (0, ""), done.stdout
    played = [line[:4] + line.split()[3].partition(":")[0] for line in done.stdout.splitlines()]
    assert played == [f"ok  {path.name}" for path in paths for _ in read_lesson(path).steps]


def test_every_drill_has_three_wrong_answers_at_least_and_two_thirds_of_the_steps_have_one() -> None:
    drills = [read_lesson(path) for path in DRILLS]
    assert [drill.name for drill in drills if len(drill.steps[0].wrong) < 3] == []
    assert [drill.fault for drill in drills] == list(range(1, 47))
    for path in DAYS:
        steps = read_lesson(path).steps
        assert sum(bool(step.wrong) for step in steps) >= len(steps) * 2 // 3, path.name
