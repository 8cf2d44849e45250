"""Every drill, healthy scene and tutorial as it once was on a real machine: the rules find in it what they found then.

No process, no clock and no disk: `record_facts.py` wrote down the facts, and `recording.py` says how.
"""

from __future__ import annotations

import dataclasses
import sys
from pathlib import Path

import pytest

from day6_core.ros.programs.day6_inspector.rules import Facts
from tests.inspector.recording import HOME, RECORDED, Case, facts_of, found_in, read_cases, recorded
from tests.inspector.scenes import ALL, Scene
from tests.support.own_places import own_places

pytestmark = pytest.mark.skipif(sys.platform == "win32", reason="paths were recorded as Linux has them")

CASES = {case.name: case for case in read_cases()}


@pytest.mark.parametrize("case", CASES.values(), ids=lambda case: case.name)
def test_what_was_found_is_found_again_and_nothing_else(case: Case) -> None:
    assert found_in(facts_of(case.facts)) == case.findings


@pytest.mark.parametrize("scene", ALL, ids=lambda scene: scene.name)
def test_a_drill_was_found_and_no_alarm_was_given_elsewhere(scene: Scene) -> None:
    found = {(level, key) for level, key, *_ in CASES[scene.name].findings}
    if scene.findings:
        assert {key for _, key in found} & set(scene.findings)
    else:
        assert {level for level, _ in found} <= {"info"}


def test_no_drill_is_found_where_nothing_is_known() -> None:
    assert found_in(Facts()) == []


def test_nothing_is_recorded_that_is_not_played_any_more() -> None:
    assert set(CASES) == {scene.name for scene in ALL}


@pytest.mark.parametrize("case", CASES.values(), ids=lambda case: case.name)
def test_facts_that_are_written_down_again_stay_the_same(case: Case) -> None:
    facts = facts_of(case.facts)
    assert recorded(case.name, facts, Path(HOME)) == case
    assert facts.pace == facts.speed and dataclasses.replace(facts) == facts


def test_the_recordings_tell_nothing_of_the_machine_on_which_they_were_made() -> None:
    assert own_places(RECORDED.read_text(encoding="utf-8")) == []
