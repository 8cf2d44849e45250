"""The shipped robots as files of one's own."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import pytest

from day6_urdf import shipped_model, shipped_models

if TYPE_CHECKING:
    from pathlib import Path

    from tests.robot.conftest import Machine


@pytest.fixture
def here(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    monkeypatch.chdir(tmp_path)
    return tmp_path


def run(machine: Machine, *args: str) -> Any:
    return machine.start("day6_bot", "copy_model", *args)


def test_without_a_name_it_says_which_there_are(machine: Machine) -> None:
    assert run(machine).output.split("\n") == [*shipped_models(), ""]


def test_it_writes_a_copy_and_never_over_one_s_work(machine: Machine, here: Path) -> None:
    assert run(machine, "day6_bot_gazebo").output == "day6_bot_gazebo.urdf written\n"
    file = here / "day6_bot_gazebo.urdf"
    assert file.read_bytes() == shipped_model("day6_bot_gazebo").read_bytes()
    file.write_text("mine", encoding="utf-8")
    assert run(machine, "day6_bot_gazebo").output == "day6_bot_gazebo.urdf is here already and stays as it is\n"
    assert file.read_text(encoding="utf-8") == "mine"


def test_an_unknown_robot_is_refused(machine: Machine, here: Path) -> None:
    running = run(machine, "../../etc/passwd")
    assert running.program.status == 1
    assert running.errors == f"there is no robot '../../etc/passwd'; there are {', '.join(shipped_models())}\n"
    assert list(here.iterdir()) == []
