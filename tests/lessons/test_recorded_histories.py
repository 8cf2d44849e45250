"""Every shipped lesson and drill as its checks once saw it played: they refuse what they refused, and take what they took.

No process and no real time: `record_histories.py` wrote down what the checks were told, `recorded_live.py` says how.
"""

from __future__ import annotations

import sys
from functools import cache
from pathlib import Path

import pytest

from day6_core.lessons.checks import kinds
from day6_core.lessons.document import Step
from day6_core.lessons.reading import read_lesson
from tests.lessons.histories import RECORDED, SHIPPED, is_refused, judged, read_histories
from tests.support.own_places import own_places
from tests.support.recorded_live import Json, packed, unpacked

pytestmark = pytest.mark.skipif(sys.platform == "win32", reason="paths were recorded as Linux has them")

HISTORIES = {(each["file"], step["step"]): step["moments"] for each in read_histories() for step in each["steps"]}
IDS = [f"{file.removesuffix('.md')}/{step}" for file, step in HISTORIES]

OTHERS = frozenset({"changes", "listens", "no_file", "no_topic", "points", "ran", "running", "service", "talks"})
"""Checks that no shipped lesson has; those that hidden scenarios have are in tests/grading/test_recorded_runs.py, those of
teachers' lessons in test_lines.py."""


@cache
def steps() -> dict[tuple[str, str], tuple[Step, Path]]:
    """Every step that ships, by its file and name, with the folder of the file."""
    return {(path.name, step.name): (step, path.parent) for path in SHIPPED for step in read_lesson(path).steps}


@pytest.mark.parametrize("where", HISTORIES, ids=IDS)
def test_checks_judge_what_they_were_told_as_they_did(where: tuple[str, str]) -> None:
    step, folder = steps()[where]
    moments = HISTORIES[where]
    found = judged(step, moments, folder)
    assert found == [each["verdicts"] for each in moments]
    assert not any(_is_broken(verdict) for verdicts in found for verdict in verdicts)


@pytest.mark.parametrize("where", HISTORIES, ids=IDS)
def test_a_step_begins_unsolved_refuses_wrong_answers_and_is_solved_at_the_end(where: tuple[str, str]) -> None:
    step, folder = steps()[where]
    moments = HISTORIES[where]
    found = list(zip(moments, judged(step, moments, folder), strict=True))
    assert moments[0]["part"] == "before"
    assert not any(_is_solved(verdicts) for moment, verdicts in found if moment["part"] == "before")
    assert moments[-1]["what"] == "solved"
    assert _is_solved(found[-1][1])
    for number in range(1, len(step.wrong) + 1):
        part = [each for each in found if each[0]["part"] == f"wrong {number}"]
        moment, verdicts = part[-1]  # before that, while it was performed, all may have held for a moment
        assert moment["what"] == "refused"
        assert is_refused(step, moment["part"], verdicts), verdicts


def test_every_step_with_all_its_wrong_answers_is_recorded_and_nothing_else() -> None:
    assert set(HISTORIES) == set(steps())
    for where, (step, _) in steps().items():
        parts = ["before", *(f"wrong {number}" for number in range(1, len(step.wrong) + 1)), "solve"]
        assert list(dict.fromkeys(each["part"] for each in HISTORIES[where])) == parts, where


def test_every_check_is_seen_to_hold_and_not_to_hold() -> None:
    used = {name for step, _ in steps().values() for name in _names(step)}
    assert set(kinds()) - used == OTHERS
    seen = {
        (part.name, verdict[0])
        for where, (step, _) in steps().items()
        for moment in HISTORIES[where]
        for part, verdict in zip(step.checks, moment["verdicts"], strict=True)
    }
    assert {name for name, holds in seen if holds} == {name for name, holds in seen if not holds}


def test_what_is_packed_comes_back() -> None:
    value = [{"a": ["x" * 50, "x" * 50]}, {"a": ["x" * 50, "x" * 50]}, 1, None, "y"]
    assert unpacked(packed(value)) == value
    assert len(packed(value)["table"]) == 2


def test_the_recording_tells_nothing_of_the_machine_on_which_it_was_made() -> None:
    assert own_places(RECORDED.read_text(encoding="utf-8")) == []


def _names(step: Step) -> list[str]:
    return [part.name for check in step.checks for part in check.every() if not part.parts]


def _is_solved(verdicts: Json) -> bool:
    return all(ok for ok, _, _ in verdicts)


def _is_broken(verdict: Json) -> bool:
    return bool(verdict[1]["say"] == "check.failed")
