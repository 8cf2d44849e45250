"""A terminal asks before something outside the home folder is changed; scripts are not asked."""

from __future__ import annotations

import sys
import tempfile
from pathlib import Path
from typing import Any

import pytest

from tests.support.broken_lines import without_blanks

PROMPT = "student@day6:~$"
CHANGING = ["rm {}", "touch {}", "cp here {}", "mv here {}", "mv {} here", "chmod 600 {}", "echo new > {}", "echo new >> {}",
            "echo new | tee {}", "rm -f here {}", "sudo rm {}", "sed -i s/mine/yours/ {}"]  # fmt: skip


@pytest.fixture
def theirs(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    """A file of the user's that is none of the lesson's."""
    monkeypatch.setattr(tempfile, "tempdir", str(tmp_path / "scratch"))
    file = tmp_path / "theirs" / "homework"
    file.parent.mkdir()
    file.write_text("mine\n", encoding="utf-8")
    file.chmod(0o644)
    return file


@pytest.mark.parametrize("command", CHANGING)
def test_a_file_outside_is_changed_only_after_a_yes(seat: Any, theirs: Path, command: str) -> None:
    seat.line("echo mine > here")
    seat.line("clear")
    question = f"{theirs} is outside your home folder. Change it? [y/N]"
    assert without_blanks(question) in without_blanks(seat.line(command.format(f"'{theirs}'")))
    screen = seat.type("\r")
    assert screen.endswith(PROMPT)
    assert theirs.read_text(encoding="utf-8") == "mine\n"
    assert sys.platform == "win32" or theirs.stat().st_mode & 0o777 == 0o644
    assert seat.line("echo status $?").splitlines()[-2] == "status 1"


def test_yes_changes_it_and_the_question_is_in_the_users_language(seat: Any, theirs: Path) -> None:
    seat.line("export DAY6_LANG=zh")
    assert "不在你的主目录里，真的要改动它吗？[y/N]" in without_blanks(seat.line(f"echo new > '{theirs}'"))
    seat.type("y\r")
    assert theirs.read_text(encoding="utf-8") == "new\n"
    seat.line(f"rm '{theirs}'")
    seat.type("y\r")
    assert not theirs.exists()
    seat.line(f"mkdir '{theirs}'")
    seat.type("\x03")
    assert not theirs.exists()
    assert seat.line("echo still here").splitlines()[-2] == "still here"


def test_the_home_folder_and_scratch_folders_are_not_asked_about(seat: Any, theirs: Path, tmp_path: Path) -> None:
    (tmp_path / "scratch").mkdir()
    seat.line(
        f"mkdir -p a/b; echo x > a/b/c; mv a z; rm -r z; echo y > '{tmp_path}/scratch/f' 2> /dev/null; cat '{theirs}' > copy"
    )
    assert seat.line("ls").splitlines()[-2:] == ["copy  ros2_ws", PROMPT]
    assert (tmp_path / "scratch" / "f").read_text(encoding="utf-8") == "y\n"


@pytest.mark.skipif(sys.platform == "win32", reason="links need a right there")
def test_a_link_that_leads_outside_is_outside(seat: Any, theirs: Path) -> None:
    (seat.desk.home / "way").symlink_to(theirs.parent)
    assert without_blanks("is outside your home folder") in without_blanks(seat.line("rm way/homework"))
    seat.type("n\r")
    assert theirs.exists()


def test_a_script_is_not_asked(machine: Any, theirs: Path) -> None:
    assert machine.run(f"echo new > '{theirs}'; rm '{theirs}'").status == 0
    assert not theirs.exists()


@pytest.mark.parametrize("command", ["colcon build", "ros2 pkg create --build-type ament_python day6_car"])
def test_nothing_is_built_or_created_outside_unasked(seat: Any, theirs: Path, command: str) -> None:
    seat.line(f"cd '{theirs.parent}'")
    seat.line("clear")
    question = f"{theirs.parent} is outside your home folder. Change it? [y/N]"
    assert without_blanks(question) in without_blanks(seat.line(command))
    seat.type("\r")
    assert sorted(path.name for path in theirs.parent.iterdir()) == ["homework"]
