"""`ran` and `running` of teachers' lessons: patterns of lines, judged by the commands that the lines really ran."""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path
from typing import Any

import pytest

from day6_core.lessons.checks import Condition, condition_of
from tests.lessons.test_typed_ways import is_counted
from tests.shell.conftest import Machine, Seat

RAN: list[tuple[dict[str, Any], tuple[str, ...], tuple[str, ...]]] = [
    ({"line": "^ls", "status": 0}, ("ls", "cd ~ && ls -l", "/bin/ls", "true; ls | cat"), ("echo ls", "true # ls", "ls x")),
    (
        {"line": r"ros2 pkg list.*\| ?grep .*[Tt]urtle", "prints": "turtlesim"},
        ("ros2 pkg list | grep turtle", "clear; ros2 pkg list|grep -i Turtle"),
        ("echo turtlesim # ros2 pkg list | grep turtle", "echo 'ros2 pkg list | grep turtle'; echo turtlesim"),
    ),
    ({"line": "^pwd", "prints": r"ros2_ws/src\s*$"}, ("cd ros2_ws/src; pwd",), ("pwd; echo ros2_ws/src", "pwd")),
    (
        {"line": "cd ~/ros2_ws; ls", "status": 0},
        ("cd ~/ros2_ws; ls", "cd ~/ros2_ws;ls # where am I?".replace(";", "; ")),
        ("echo 'cd ~/ros2_ws; ls' && false", "cd ~/ros2_ws; lss"),
    ),
    ({"line": "ROS_DISTRO", "prints": "jazzy"}, ("echo $ROS_DISTRO", "printenv ROS_DISTRO"), ("echo ROS_DISTRO jazzy",)),
    ({"line": "echo h", "prints": "hello"}, ("x=ello; echo h$x | cat",), ("echo hello", "bash -c 'echo hello'")),
]  # fmt: skip


@pytest.fixture
def machine(tmp_path: Path) -> Iterator[Machine]:
    made = Machine(tmp_path / "home")
    yield made
    made.desk.close()


def check_of(**given: Any) -> Condition:
    made = condition_of(given)
    assert isinstance(made, Condition), made
    return made


def test_a_pattern_of_a_line_is_about_commands_that_were_run(machine: Machine) -> None:
    wrong = []
    for given, right, cheats in RAN:
        counted = {way: is_counted(machine, [check_of(ran=given)], way) for way in (*right, *cheats)}
        wrong += [(given["line"], way) for way, counts in counted.items() if counts != (way in right)]
    assert wrong == []


@pytest.mark.parametrize("check", [{"running": "sleep 60"}, {"runs": "sleep 60"}], ids=str)
def test_only_what_really_runs_is_running(machine: Machine, check: dict[str, str]) -> None:
    from day6_core.lessons.live import Live

    seat, live = Seat(machine.desk), Live(machine.desk, None, machine.desk.home)
    condition = check_of(**check)
    seat.line("echo sleep 60; sleep 50 # sleep 60")
    assert condition.judge(live).text("en").endswith("Running now: sleep 50.")
    seat.type("\x03")
    for line in ("clear; sleep 60", "timeout 90 sleep 60", "bash -c 'cd; sleep 60'", "(sleep 60) & sleep 50"):
        seat.line(line)
        assert condition.judge(live).ok, line
        seat.type("\x03")
        seat.line("kill %1")
        seat.settle(1.0)
        assert not condition.judge(live).ok, line


def test_a_command_is_found_with_options_between_its_words_and_by_any_path_of_its_file(machine: Machine) -> None:
    cases = {
        ("cat|less ~/ros2_ws/a.txt", "cd ros2_ws; touch a.txt; cat -n ./a.txt"): True,
        ("cat|less ~/ros2_ws/a.txt", "cat ros2_ws/src/../a.txt"): True,
        ("cat|less ~/ros2_ws/a.txt", "touch a.txt; cat a.txt"): False,
        ("ros2 topic list", "ros2 -x topic list"): True,
        ("ros2 topic list", "ros2 node list; echo topic"): False,
        ("ros2 topic info /x", "ros2 topic info -v x"): True,
        ("ros2 topic info /x", "ros2 topic info /y /x"): False,
        ("ros2 topic info /x", "ros2 topic info /x -h"): False,
        ("python3 *.py", "python3_ a.py; echo python3 a.py"): False,
    }
    found = {case: is_counted(machine, [check_of(command=case[0])], case[1]) for case in cases}
    assert found == cases


def test_what_goes_on_in_the_background_of_an_old_line_is_looked_at_and_old_lines_are_not(machine: Machine) -> None:
    from day6_core.lessons.live import Live

    seat = Seat(machine.desk)
    seat.line("ls; sleep 100 &")
    seat.line("pwd")
    machine.go(1.0)
    live = Live(machine.desk, None, machine.desk.home)
    assert [ran.argv for ran in live.commands(live.now_ns())] == [["sleep", "100"]]
    seat.line("kill %1; wait")
    assert [ran.argv[0] for ran in live.commands(live.lesson_began_ns)] == ["sleep", "kill", "wait"]
    assert [run.over_ns is not None for run in seat.terminal.runs.all] == [True] * 3
