"""Hints below errors in a terminal, in its language, and colcon's colours there; never in a pipe, a file or a script."""

from __future__ import annotations

import os
from typing import Any

import pytest

pytestmark = pytest.mark.skipif(os.name == "nt", reason="a terminal there has no pty")

SLIP = "count = 1\nprint(cuont)\n"


@pytest.mark.process
def test_a_traceback_is_followed_by_a_hint_in_the_language_of_the_terminal(machine: Any, seat: Any) -> None:
    (machine.desk.home / "slip.py").write_text(SLIP)
    seat.line("python3 slip.py")
    lines = seat.wait_prompt().splitlines()
    assert lines[-3].startswith("NameError: name 'cuont' is not defined")
    assert lines[-2:] == ["hint: nothing is called cuont here; did you mean count?", "student@day6:~$"]
    seat.line("clear; export DAY6_LANG=zh; python3 slip.py 2>&1")
    assert seat.wait_prompt().splitlines()[-2] == "提示：这里没有叫 cuont 的东西，是不是想写 count？"
    seat.line("clear; DAY6_HINTS=off python3 slip.py")
    assert "提示" not in seat.wait_prompt()


@pytest.mark.process
@pytest.mark.parametrize(
    "line", ["python3 slip.py 2>&1 | cat", "python3 slip.py 2> f; cat f", "echo $(python3 slip.py 2>&1)"]
)
def test_there_is_no_hint_where_nobody_reads_it(machine: Any, seat: Any, line: str) -> None:
    (machine.desk.home / "slip.py").write_text(SLIP)
    seat.line(line)
    seen = seat.wait_prompt().replace("\n", "")
    assert "NameError" in seen and "hint:" not in seen
    assert "hint:" not in machine.run(line).out + machine.run("python3 slip.py").err


@pytest.mark.parametrize("command", ["cd", "ls", "source", pytest.param("python3", marks=pytest.mark.process), "cat"])
def test_a_path_typed_from_the_article_is_told_where_home_is(machine: Any, seat: Any, command: str) -> None:
    seat.line(f"{command} /home/student/ros2_ws/src")
    seen = "".join(seat.wait_prompt().split())  # lines break anywhere, by the length of the home folder's name
    for told in (
        "No such file or directory",
        "hint: there is no /home/student here: your home folder is ~.",
        "~/ros2_ws/src, or $HOME/ros2_ws/src",
    ):
        assert "".join(told.split()) in seen
    seat.line(f"clear; {command} /home/student/nothing; {command} /nothing; ls /home/student/ros2_ws 2>&1 | cat")
    assert "hint:" not in seat.wait_prompt()


@pytest.mark.parametrize(
    ("typed", "meant"),
    [
        ("pyhton3 x.py", "python3"),
        ("rso2 topic list", "ros2"),
        ("colon build", "colcon"),
        ("foo", ""),
        ("frobnicate", ""),
    ],
)
def test_a_slip_in_a_command_is_asked_about(seat: Any, typed: str, meant: str) -> None:
    seen = seat.line(typed)
    assert f"bash: {typed.split()[0]}: command not found" in seen
    assert (f"there is no command {typed.split()[0]}; did you mean {meant}?" in seen) if meant else "hint" not in seen


def test_a_command_that_exists_and_ends_with_127_is_no_slip(seat: Any) -> None:
    seen = seat.line("pyton3() { return 127; }; pyton3; sudo nothing; bash nothing; echo over")
    assert "over" in seen and "hint" not in seen


@pytest.mark.process
def test_a_package_that_is_not_built_or_not_sourced_is_told_so(machine: Any, seat: Any) -> None:
    assert machine.run("cd ros2_ws/src; ros2 pkg create --build-type ament_python --node-name go car").status == 0
    seat.line("ros2 run car go")
    lines = seat.wait_prompt().replace("\n", "")
    assert "Package 'car' not found" in lines and "but it hasn't been built yet. Run: cd" in lines
    seat.line("clear; colcon build")
    assert "there is no package below this folder" not in seat.wait_prompt()  # this is home, and ros2_ws is below it
    seat.line("clear; mkdir empty; cd empty; colcon build")
    assert "there is no package below this folder" in seat.wait_prompt()
    seat.line("clear; cd ~/ros2_ws/src; colcon build")
    assert "hint: this is the folder src" in seat.wait_prompt()
    seat.line("rm -r build install log; clear; cd ..; colcon build; ros2 launch car no.launch.py")
    lines = seat.wait_prompt().replace("\n", "")
    assert (
        "hint: car is built, but this terminal doesn't know it yet. Run: source" in lines and "folder src" not in lines
    )
    seat.line("clear; source install/setup.bash; ros2 run car no; ros2 run turtlesim no")
    assert "hint:" not in seat.wait_prompt()


def test_a_package_whose_build_failed_is_told_so(machine: Any, seat: Any) -> None:
    made = machine.run(
        "cd ros2_ws/src; ros2 pkg create car; echo 'install(FILES no DESTINATION .)' >> car/CMakeLists.txt"
    )
    assert made.status == 0
    seat.line("cd ros2_ws; colcon build; source install/setup.bash; clear; ros2 run car go")
    lines = seat.wait_prompt().replace("\n", "")
    assert (
        "hint: car is in" in lines and "its last build failed. See why: cd" in lines and "been built yet" not in lines
    )
    seat.line("clear; why")
    assert "its last build failed: what colcon build prints says why" in " ".join(seat.wait_prompt().split())


@pytest.mark.process
def test_colcon_is_coloured_and_explains_what_failed_on_a_terminal_only(machine: Any, seat: Any) -> None:
    package = machine.desk.home / "ros2_ws" / "src" / "car"
    assert machine.run("cd ros2_ws/src; ros2 pkg create --build-type ament_python car").status == 0
    text = (package / "setup.py").read_text().replace("from setuptools import", "from setuptols import")
    (package / "setup.py").write_text(text)
    machine.shell.cwd = machine.desk.home / "ros2_ws"
    done = machine.run("colcon build")
    assert done.status == 1 and "\x1b" not in done.out + done.err and "hint:" not in done.err
    seat.line("export DAY6_LANG=zh; cd ~/ros2_ws; colcon build")
    lines = seat.wait_prompt().splitlines()
    assert lines[-2] == "提示：没有叫 setuptols 的模块，是不是想写 setuptools？"
    rows = [row for y in range(24) if (row := seat.terminal.screen.row(y))]
    colours = {(row[0][0], row[0][1].fg, row[0][1].bold) for row in rows if not isinstance(row, str)}
    assert {("--- stderr: car", "red", False), ("Failed", "red", True)} <= colours
    assert ("  1 package failed: ", "red", False) in colours and (
        "  1 package had stderr output: ",
        "brown",
        False,
    ) in colours
