"""Log files: where they are, what they are called, what is in them; and the environment of a terminal that logging obeys."""

from __future__ import annotations

import re
import subprocess
import sys
from pathlib import Path

from day6_tui.core.ros.environment import program_environment

PROGRAM = """
import sys, rclpy
rclpy.init(args=sys.argv)
node = rclpy.create_node("n", namespace="/ns")
node.get_logger().debug("quiet")
node.get_logger().warning("loud")
"""


def run(home: Path, *words: str, **env: str) -> subprocess.CompletedProcess[str]:
    """Run a student's program whose home folder this is."""
    inherited = {name: value for name, value in program_environment().items() if not name.startswith("ROS_LOG")}
    environment = {**inherited, "HOME": str(home), "USERPROFILE": str(home), **env}
    return subprocess.run([sys.executable, "-c", PROGRAM, *words], env=environment, capture_output=True, text=True)


def logs(folder: Path) -> list[str]:
    return sorted(path.relative_to(folder).as_posix() for path in folder.rglob("*") if path.is_file())


def test_a_program_leaves_a_log_file_with_what_it_said_and_no_colours(tmp_path: Path) -> None:
    done = run(tmp_path, RCUTILS_COLORIZED_OUTPUT="1")
    assert "\x1b[33m" in done.stderr
    (name,) = logs(tmp_path)
    assert re.fullmatch(r"\.ros/log/[\w.]+_\d+_\d{13}\.log", name), name
    assert re.fullmatch(r"\[WARN\] \[\d+\.\d{9}\] \[ns\.n\]: loud\n", (tmp_path / name).read_text())


def test_the_folder_is_named_by_ros_log_dir_or_ros_home(tmp_path: Path) -> None:
    run(tmp_path, ROS_LOG_DIR=str(tmp_path / "a"), ROS_HOME=str(tmp_path / "b"))
    run(tmp_path, ROS_LOG_DIR="", ROS_HOME=str(tmp_path / "b"))
    run(tmp_path, ROS_LOG_DIR="~/c")
    assert [name.rpartition("/")[0] for name in logs(tmp_path)] == ["a", "b/log", "c"]


def test_arguments_name_the_file_or_switch_it_off(tmp_path: Path) -> None:
    run(tmp_path, "--ros-args", "--log-file-name", "mine", "--disable-stdout-logs")
    run(tmp_path, "--ros-args", "--disable-external-lib-logs")
    (name,) = logs(tmp_path)
    assert name.startswith(".ros/log/mine_")
    refused = run(tmp_path, "--ros-args", "--log-config-file", "x")
    assert "spdlog logging backend doesn't currently support external configuration" in refused.stderr


def test_a_folder_that_cannot_be_made_is_an_error_only_where_it_was_asked_for(tmp_path: Path) -> None:
    (tmp_path / "file").write_text("")
    asked = run(tmp_path, ROS_LOG_DIR=str(tmp_path / "file" / "x"))
    assert "RCLError: failed to initialize logging: Failed to create log directory" in asked.stderr
    unasked = run(tmp_path / "file")
    assert unasked.returncode == 0 and "loud" in unasked.stderr
