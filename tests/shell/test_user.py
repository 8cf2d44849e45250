"""The name in the prompt is the login name of the real machine, where there is one that can be used."""

from __future__ import annotations

import getpass
from pathlib import Path
from typing import Any

import pytest

from day6_core.session.clock import WorldClock
from day6_core.shell.desk import Desk


@pytest.fixture
def machine_of(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Any:
    """Makes the machine of the user that the real one knows by this name."""
    desks = []

    def make(name: str) -> Any:
        monkeypatch.setenv("LOGNAME", name)
        desks.append(Desk(tmp_path / "home", domain_id=0, join_link=False, clock=WorldClock(wall=None)))
        return desks[-1]

    yield make
    for desk in desks:
        desk.close()


@pytest.mark.parametrize(
    ("login", "shown"),
    [("xiaoming", "xiaoming"), ("小明", "小明"), ("li.hua-2", "li.hua-2"), ("root", "student"), ("Li Hua", "student"),
     ("a@b.example", "student"), ("\x1b[31mred", "student"), ("x" * 40, "student")],
)  # fmt: skip
def test_the_prompt_and_every_command_call_the_user_by_the_login_name(
    machine_of: Any, seat_at: Any, login: str, shown: str
) -> None:
    seat = seat_at(machine_of(login))
    assert seat.look() == f"{shown}@day6:~$"
    lines = seat.line(f"whoami; id -un; echo $USER $LOGNAME; cd ~{shown} && ls; USER=other; whoami")
    assert lines.splitlines()[-6:-1] == [shown, shown, f"{shown} {shown}", "ros2_ws", shown]


def test_without_any_name_the_user_is_a_student(machine_of: Any, monkeypatch: pytest.MonkeyPatch) -> None:
    def nobody() -> str:
        raise OSError("No username set in the environment")

    monkeypatch.setattr(getpass, "getuser", nobody)
    assert machine_of("").user == "student"
