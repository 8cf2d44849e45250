"""Grading inside a cell, as the class page has it done."""

from __future__ import annotations

import asyncio
import sys
import tempfile
from pathlib import Path
from types import SimpleNamespace

import pytest

if sys.platform != "linux":
    pytest.skip("pupils are kept apart on Linux only", allow_module_level=True)

from day6_core.isolation import landlock
from day6_core.isolation.cell import Limits
from day6_core.isolation.same_user import Landlock
from day6_core.lessons.grading import grader
from day6_core.lessons.grading.scenarios import gradings
from day6_core.lessons.work import LESSON, Task, Work, pack
from day6_tui.web.grading_room import GradingRoom

pytestmark = [
    pytest.mark.process,
    pytest.mark.skipif(landlock.version() < 1, reason="this Linux has no Landlock"),
]


def test_where_programs_cannot_meet_none_is_called_wrong(tmp_path: Path) -> None:
    """The path of a socket would be too long in the cell, and what stands in for it is closed."""
    (grading := tmp_path / "grading").mkdir()
    places = SimpleNamespace(grading=grading, runtimes=tmp_path / ("deep" * 20), hidden=())
    room = GradingRoom(Landlock(), places, Limits())  # type: ignore[arg-type]
    packed = pack(Task(LESSON, ("day3",)), Work({"star.py": b"import rclpy\n"}), "anna", "anna")
    played = [each for each in gradings() if each.lesson == "day3"]
    report = asyncio.run(room.grade("anna", packed, played, {}, "seed"))
    assert "too long" in report["problem"]
    assert {each["mark"] for each in report["scenarios"]} == {"unplayed"}


def test_the_folder_of_a_graded_submission_is_as_short_as_the_cell_allows(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    made = tempfile.mkdtemp

    def closed(**told: str) -> str:
        if told.get("dir") == "/tmp":
            raise PermissionError
        return made(**told)

    monkeypatch.setattr(tempfile, "mkdtemp", closed)
    monkeypatch.setenv("DAY6_RUNTIME_DIR", str(tmp_path))
    assert Path(grader._folder()).parent == tmp_path
