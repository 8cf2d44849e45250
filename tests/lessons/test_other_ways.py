"""A drill is judged by what works afterwards: other good ways count, and what only looks right is refused (`other_ways.yaml`).

So are steps of the days: their ways are named `day1/packages`, and the steps they need are played before.
"""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path
from typing import Any

import pytest
import yaml

from day6_core.lessons.catalogue import HERE
from day6_core.lessons.document import Step, Wrong
from day6_core.lessons.reading import read_lesson
from day6_core.lessons.rehearsal import rehearse

WAYS = yaml.safe_load(Path(__file__).with_name("other_ways.yaml").read_text(encoding="utf-8"))
CASES = [pytest.param(fault, way, id=f"{fault}: {way['name']}") for fault, ways in WAYS.items() for way in ways]


@pytest.mark.process
@pytest.mark.virtual_time
@pytest.mark.parametrize(("fault", "way"), CASES)
def test_a_way_of_ones_own_is_judged_by_its_effect(fault: str, way: dict[str, Any], tmp_path: Path) -> None:
    folder, pattern, name = ("days", *fault.split("/")) if "/" in fault else ("drills", f"{fault}_*", "")
    lesson = read_lesson(next((HERE / folder).glob(f"{pattern}.md")))
    step = next(each for each in lesson.steps if each.name == name or not name)
    if "good" in way:
        tried = replace(step, wrong=(), solve=tuple(way["good"]))
    else:
        tried = replace(step, wrong=(Wrong(tuple(way["bad"]), way["says"], tuple(way.get("undo", ()))),))
    before = [replace(each, wrong=()) for each in lesson.steps if each.name in _needed(lesson.steps, step)]
    played = rehearse(replace(lesson, steps=(*before, tried)), tmp_path / "home")
    assert [each.faults for each in played] == [[] for _ in played]


def _needed(steps: tuple[Step, ...], step: Step) -> set[str]:
    """Names of the steps whose state this one needs, and of those they need themselves."""
    found = set(step.needs)
    for each in steps:
        if each.name in step.needs:
            found |= _needed(steps, each)
    return found
