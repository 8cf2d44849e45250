"""Every shipped lesson and drill, played: each step begins unsolved, refuses its wrong answers, is solved by its solution."""

from __future__ import annotations

from pathlib import Path

import pytest

from day6_tui.core.lessons.catalogue import HERE
from day6_tui.core.lessons.document import read_lesson
from day6_tui.core.lessons.rehearsal import rehearse

FILES = [HERE / "example.md", *sorted((HERE / "days").glob("*.md")), *sorted((HERE / "drills").glob("*.md"))]


@pytest.mark.parametrize("path", FILES, ids=lambda path: path.stem)
def test_it_is_solved_by_its_solutions_alone(path: Path, tmp_path: Path) -> None:
    lesson = read_lesson(path)
    played = rehearse(lesson, tmp_path / "home")
    assert [(each.step, each.faults) for each in played] == [(step.name, []) for step in lesson.steps]


def test_every_drill_has_three_wrong_answers_and_two_thirds_of_the_steps_have_one() -> None:
    drills = [read_lesson(path) for path in sorted((HERE / "drills").glob("*.md"))]
    assert [(drill.name, len(drill.steps[0].wrong)) for drill in drills] == [(drill.name, 3) for drill in drills]
    for path in sorted((HERE / "days").glob("*.md")):
        steps = read_lesson(path).steps
        assert sum(bool(step.wrong) for step in steps) >= len(steps) * 2 // 3, path.name
