"""A drill is judged by what works afterwards: other good ways count, and what only looks right is refused (`other_ways.yaml`)."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path
from typing import Any

import pytest
import yaml

from day6_tui.core.lessons.catalogue import HERE
from day6_tui.core.lessons.document import Wrong, read_lesson
from day6_tui.core.lessons.rehearsal import rehearse

WAYS = yaml.safe_load(Path(__file__).with_name("other_ways.yaml").read_text(encoding="utf-8"))
CASES = [pytest.param(fault, way, id=f"{fault}: {way['name']}") for fault, ways in WAYS.items() for way in ways]


@pytest.mark.parametrize(("fault", "way"), CASES)
def test_a_way_of_ones_own_is_judged_by_its_effect(fault: str, way: dict[str, Any], tmp_path: Path) -> None:
    lesson = read_lesson(next((HERE / "drills").glob(f"{fault}_*.md")))
    (step,) = lesson.steps
    if "good" in way:
        step = replace(step, wrong=(), solve=tuple(way["good"]))
    else:
        step = replace(step, wrong=(Wrong(tuple(way["bad"]), way["says"], tuple(way.get("undo", ()))),))
    (played,) = rehearse(replace(lesson, steps=(step,)), tmp_path / "home")
    assert played.faults == []
