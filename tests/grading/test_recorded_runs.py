"""Forgeries as they once were played are refused for their reasons again, and a good submission passes: without any process.

`Play` itself grades what `record_runs.py` wrote down; `recorded_runs.py` says how.
"""

from __future__ import annotations

import math
import re
import sys
import tempfile
from copy import deepcopy
from dataclasses import replace
from functools import cache
from pathlib import Path
from typing import Any

import pytest

from day6_core.lessons.grading.marks import Mark, Seen
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


@pytest.mark.parametrize("name", [name for name in SUBMISSIONS if name.startswith(GOOD)])
def test_what_is_right_gets_all_points_in_whatever_way_it_is_done(name: str) -> None:
    found = graded(name)
    assert list(found) == [each.name for grading in SUBMISSIONS[name].gradings for each in grading.scenarios]
    assert {name: each.problems for name, each in found.items() if each.problems} == {}
    assert all((each.outcome.mark, each.outcome.points) == (Mark.RIGHT, 1.0) for each in found.values())
    assert all(check.at is not None for each in found.values() for check in each.outcome.checks)


CHEATS = re.compile(
    r"jumps from|turns by teleport|brings back turtle1|publishes poses|prints|says that it|lets `|somebody else|publishes once"
    r"|faker|memory|open files|writes|for the node without|talks to itself|another node of its own|an rclpy of its own"
    r"|exit status|only what a build leaves|text that says|stands still|never spins|trembles"
)
CHEATING = [each for each in FORGERIES if CHEATS.search(each.name) and each.name != "prints nothing"]


@pytest.mark.parametrize("forgery", CHEATING, ids=lambda forgery: forgery.id)
def test_cheats_get_no_points_at_all(forgery: Forgery) -> None:
    outcome = graded(WHERE[forgery.id])[forgery.scenario].outcome
    assert (outcome.mark, outcome.points) == (Mark.WRONG, 0.0)
    assert not (outcome.timed and "teleport" in forgery.reason)  # a busy machine is no excuse


def test_there_are_cheats_for_every_day() -> None:
    assert {each.lesson for each in CHEATING} == {each.lesson for each in gradings()}


@pytest.mark.parametrize(
    ("forgery", "points", "where"),
    [
        ("elsewhere: draws four lines", 0.6, "corner 1: asked"),
        (
            "elsewhere: draws lines of five lengths",
            0.2,
            r"corner 3: asked \(\d\.\d, \d\.\d\) ± 0\.2 m, seen .* after \d+\.\d s",
        ),
        ("elsewhere: draws a square", 0.0, "corner 3: asked"),
        ("spinner: turns the left wheel only", 0.83, ""),
        ("urdf: has no right wheel", 0.33, ""),
        ("builds: names no dependencies", 0.5, ""),
        ("talker: floods the topic once a millisecond", 0.8, ""),
    ],
)
def test_what_is_partly_right_gets_a_part_of_the_points(forgery: str, points: float, where: str) -> None:
    outcome = graded(WHERE[forgery])[forgery.partition(":")[0]].outcome
    assert (outcome.mark, outcome.points) == (Mark.WRONG, points)
    told = [each.where.text("en") for each in outcome.checks if each.where is not None]
    assert bool(told) is bool(where) and re.search(where, " ".join(told))


@pytest.mark.parametrize(("running", "mark"), [(True, Mark.LATE), (False, Mark.WRONG)])
def test_a_figure_that_is_right_so_far_ran_out_of_time_while_its_program_runs(
    running: bool, mark: Mark, tmp_path: Path
) -> None:
    name = f"{GOOD} by the pose"
    runs = deepcopy(RUNS[name]["runs"])
    (elsewhere,) = (run for run in runs if run["scenario"] == "elsewhere")
    last = elsewhere["events"][-1]["moment"]
    (window,) = last["windows"]
    drawn = window["trail"][-1]
    end = drawn[-1]
    while math.dist(drawn[-1], end) < 1.2:  # half of the last side is missing
        drawn.pop()
    for terminal in last["terminals"]:
        terminal["running"] = ["python3 ~/star.py"] * running
    outcome = graded_again(SUBMISSIONS[name], runs, tmp_path)["elsewhere"].outcome
    assert (outcome.mark, outcome.points) == (mark, 0.6)
    assert outcome.checks[0].where is not None


def test_what_needs_a_scenario_that_failed_is_not_played(tmp_path: Path) -> None:
    spoiled = SUBMISSIONS[WHERE["urdf: is empty"]]
    (day6,) = (each for each in gradings() if each.lesson == "day6")
    both = replace(day6, scenarios=tuple(each for each in day6.scenarios if each.name in ("urdf", "launch")))
    heard: dict[str, Any] = {}
    submission, runs = spoiled._replace(gradings=(both,)), RUNS[spoiled.name]["runs"]
    played = graded_again(submission, runs, tmp_path, lambda **said: heard.update({said["scenario"]: said}))
    assert list(played) == ["urdf"]
    assert {name: each["mark"] for name, each in heard.items()} == {"urdf": "wrong", "launch": "unplayed"}
    needs = Seen(Say("grade.needs", name="urdf"), Say("grade.needs_saw"))
    assert heard["launch"]["checks"] == [needs.data()]


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
