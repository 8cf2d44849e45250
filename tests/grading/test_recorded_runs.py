"""Forgeries as they once were played are refused for their reasons again, and a good submission passes: without any process.

`Play` itself grades what `record_runs.py` wrote down; `recorded_runs.py` says how.
"""

from __future__ import annotations

import re
import sys
import tempfile
from dataclasses import replace
from functools import cache
from pathlib import Path
from typing import Any

import pytest

from day6_core.lessons.grading.scenarios import gradings
from day6_core.lessons.texts import Say
from tests.grading.forgeries import ALL, Forgery
from tests.grading.recorded_runs import ATTACKS, GOOD, RECORDED, Graded, graded_again, reasons, submissions
from tests.support.own_places import own_places
from tests.support.recorded_live import read_lines

pytestmark = pytest.mark.skipif(sys.platform == "win32", reason="paths were recorded as Linux has them")

SUBMISSIONS = {each.name: each for each in submissions()}
RUNS = {each["submission"]: each for each in read_lines(RECORDED)}
WHERE = {forgery.id: name for name, each in SUBMISSIONS.items() for forgery in each.forgeries}
FORGERIES = [forgery for forgery in ALL if forgery.id not in ATTACKS]


@cache
def graded(name: str) -> dict[str, Graded]:
    """How the scenarios of a submission go, by their names."""
    with tempfile.TemporaryDirectory() as home:
        return graded_again(SUBMISSIONS[name], RUNS[name]["runs"], Path(home))


@pytest.mark.parametrize("forgery", FORGERIES, ids=lambda forgery: forgery.id)
def test_it_is_refused_for_its_reason_again(forgery: Forgery) -> None:
    problems = graded(WHERE[forgery.id])[forgery.scenario].problems
    said = reasons(problems)
    assert problems
    assert re.search(forgery.reason, said), said
    assert "Traceback" not in said


def test_a_good_submission_passes() -> None:
    found = graded(GOOD)
    assert list(found) == [scenario.name for grading in gradings() for scenario in grading.scenarios]
    assert {name: each.problems for name, each in found.items() if each.problems} == {}


def test_what_needs_a_scenario_that_failed_is_not_played(tmp_path: Path) -> None:
    spoiled = SUBMISSIONS[WHERE["urdf: is empty"]]
    (day6,) = (each for each in gradings() if each.lesson == "day6")
    both = replace(day6, scenarios=tuple(each for each in day6.scenarios if each.name in ("urdf", "launch")))
    heard: dict[str, Any] = {}
    submission, runs = spoiled._replace(gradings=(both,)), RUNS[spoiled.name]["runs"]
    played = graded_again(submission, runs, tmp_path, lambda **said: heard.update({said["scenario"]: said}))
    assert list(played) == ["urdf"]
    assert {name: each["ok"] for name, each in heard.items()} == {"urdf": False, "launch": False}
    needs, saw = Say("grade.needs", name="urdf"), Say("grade.needs_saw")
    assert heard["launch"]["problems"] == [[needs.text("zh"), needs.text("en"), saw.text("zh"), saw.text("en")]]


@pytest.mark.parametrize("name", SUBMISSIONS)
def test_every_look_sees_what_it_saw(name: str) -> None:
    runs = RUNS[name]["runs"]
    looks = {
        run["scenario"]: [each["moment"]["verdicts"] for each in run["events"] if each["do"] == "look"] for run in runs
    }
    assert looks == {scenario: each.looks for scenario, each in graded(name).items()}
    assert {run["scenario"]: run["problems"] for run in runs} == {
        scenario: each.problems for scenario, each in graded(name).items()
    }


def test_what_is_recorded_is_what_would_be_played() -> None:
    assert {name: each["fingerprint"] for name, each in RUNS.items()} == {
        name: each.fingerprint for name, each in SUBMISSIONS.items()
    }, "play them again: python -m tests.grading.record_runs"


def test_what_is_left_out_are_attacks_on_the_judge() -> None:
    assert {forgery.id for forgery in ALL} - set(WHERE) == set(ATTACKS)
    assert len(FORGERIES) > 90


def test_the_recording_tells_nothing_of_the_machine_on_which_it_was_made() -> None:
    assert own_places(RECORDED.read_text(encoding="utf-8")) == []
