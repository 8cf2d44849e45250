"""Every shipped lesson and drill, played: each step begins unsolved, refuses its wrong answers, is solved by its solution.

Playing is mostly waiting, for processes to start and turtles to arrive: so `day6-tui lessons play` runs for several files at
a time, beside the other tests, from when the first of these begins.
"""

from __future__ import annotations

import subprocess
import sys
from collections.abc import Iterator, Sequence
from concurrent.futures import Future, ThreadPoolExecutor
from pathlib import Path

import pytest

from day6_core.lessons.catalogue import HERE
from day6_core.lessons.reading import read_lesson
from tests.support.waiting import run

AT_A_TIME = 5
TOGETHER = 8
"""As many short files are given to one command."""

LONGEST = 400.0
"""Seconds of a core for one command."""

DAYS = sorted((HERE / "days").glob("*.md"))
DRILLS = sorted((HERE / "drills").glob("*.md"))
FILES = [*DAYS, HERE / "example.md", HERE / "example_drill.md", *DRILLS]

Played = Future["subprocess.CompletedProcess[str]"]


def play(paths: Sequence[Path]) -> subprocess.CompletedProcess[str]:
    """Play lesson files as their author would."""
    command = [sys.executable, "-m", "day6_tui.main", "lessons", "play", *map(str, paths)]
    done: subprocess.CompletedProcess[str] = run(command, None, LONGEST)
    return done


@pytest.fixture(scope="module")
def playing() -> Iterator[dict[Path, Played]]:
    """All files are played from now on, a few at a time."""
    short = [path for path in FILES if path not in DAYS]
    groups = [[path] for path in DAYS] + [short[begin : begin + TOGETHER] for begin in range(0, len(short), TOGETHER)]
    with ThreadPoolExecutor(AT_A_TIME) as pool:
        played = [(paths, pool.submit(play, paths)) for paths in groups]
        yield {path: done for paths, done in played for path in paths}


@pytest.mark.process
@pytest.mark.parametrize("path", FILES, ids=lambda path: path.stem)
def test_it_is_solved_by_its_solutions_alone(path: Path, playing: dict[Path, Played]) -> None:
    done = playing[path].result()
    assert done.stderr == ""
    assert (done.returncode == 0) == ("FAIL" not in done.stdout)
    lines = [line for line in done.stdout.splitlines() if f"  {path.name}:" in line]
    assert [line[:4] for line in lines] == ["ok  "] * len(read_lesson(path).steps), done.stdout


def test_every_drill_has_three_wrong_answers_at_least_and_two_thirds_of_the_steps_have_one() -> None:
    drills = [read_lesson(path) for path in DRILLS]
    assert [drill.name for drill in drills if len(drill.steps[0].wrong) < 3] == []
    assert [drill.fault for drill in drills] == list(range(1, 47))
    for path in DAYS:
        steps = read_lesson(path).steps
        assert sum(bool(step.wrong) for step in steps) >= len(steps) * 2 // 3, path.name
