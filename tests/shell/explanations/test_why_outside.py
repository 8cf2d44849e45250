"""`day6-tui why` in a real terminal: every command that it names exists there."""

from __future__ import annotations

import os
from pathlib import Path

import pytest

from day6_core.ros.executables import with_executables
from day6_core.shell.builtins.why import for_real_terminal
from day6_tui.main import main

EMPTY = {"PATH": "/nowhere"}


@pytest.mark.parametrize(("language", "said"), [("en", "There is no card for this."), ("zh", "这句话没有卡片。")])
def test_a_text_without_a_card_names_the_command_that_lists_them(
    monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str], language: str, said: str
) -> None:
    monkeypatch.setenv("DAY6_LANG", language)
    assert main(["why", "zzz"]) == 1
    told = capsys.readouterr().err
    assert told.startswith(f"day6-tui why: {said}") and told.count("day6-tui why") == 2
    assert "explain" not in told


def test_what_to_type_next_is_what_this_terminal_has(capsys: pytest.CaptureFixture[str]) -> None:
    assert main(["why", "Package 'turtlesm' not found"]) == 0
    assert "day6-tui" in capsys.readouterr().out.partition("Type next")[2].partition("\n\n")[0]


@pytest.mark.parametrize(
    ("line", "typed"),
    [
        ("ros2 run turtlesim turtlesim_node", "day6-tui ros2 run turtlesim turtlesim_node"),
        (
            "cd ~/ros2_ws; colcon build && ros2 pkg list",
            "cd ~/ros2_ws; day6-tui colcon build && day6-tui ros2 pkg list",
        ),
        ("rqt_graph", "day6-tui rqt_graph"),
        ("python3 talker.py", "day6-tui python talker.py"),
        ("python3 -m venv x", "python3 -m venv x"),
        ("ls ros2", "ls ros2"),
        ("day6-tui export car", "day6-tui export car"),
        ("source /opt/ros/no_such_one/setup.bash", "day6-tui shell"),
        ("source install/setup.bash", "source install/setup.bash"),
        ("", ""),
    ],
)
def test_a_line_of_the_desktop_as_it_is_typed_elsewhere(line: str, typed: str) -> None:
    assert for_real_terminal(line, EMPTY) == typed


def test_where_the_command_exists_the_line_stays(tmp_path: Path) -> None:
    ours = {"PATH": with_executables("/usr/bin")}
    assert for_real_terminal("ros2 topic list", ours) == "ros2 topic list"
    name = "ros2.bat" if os.name == "nt" else "ros2"
    (tmp_path / name).write_text("", encoding="utf-8")
    (tmp_path / name).chmod(0o755)
    assert for_real_terminal("ros2 topic list", {"PATH": str(tmp_path)}) == "ros2 topic list"  # a real ROS
