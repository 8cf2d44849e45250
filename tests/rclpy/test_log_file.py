"""Log files: where they are, what they are called, what is in them; and the environment of a terminal that logging obeys."""

from __future__ import annotations

import os
import re
import subprocess
import sys
from pathlib import Path

import pytest

from day6_core.ros.environment import program_environment
from rclpy._day6.log_file import LogFile, logging_directory, of_process

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


@pytest.mark.process
def test_a_program_leaves_a_log_file_with_what_it_said_and_no_colours(tmp_path: Path) -> None:
    done = run(tmp_path, RCUTILS_COLORIZED_OUTPUT="1")
    assert "\x1b[33m" in done.stderr
    (name,) = logs(tmp_path)
    assert re.fullmatch(r"\.ros/log/[\w.]+_\d+_\d{13}\.log", name), name
    assert re.fullmatch(r"\[WARN\] \[\d+\.\d{9}\] \[ns\.n\]: loud\n", (tmp_path / name).read_text())


@pytest.mark.process
def test_the_folder_is_named_by_ros_log_dir_or_ros_home(tmp_path: Path) -> None:
    run(tmp_path, ROS_LOG_DIR=str(tmp_path / "a"), ROS_HOME=str(tmp_path / "b"))
    run(tmp_path, ROS_LOG_DIR="", ROS_HOME=str(tmp_path / "b"))
    run(tmp_path, ROS_LOG_DIR="~/c")
    assert [name.rpartition("/")[0] for name in logs(tmp_path)] == ["a", "b/log", "c"]


@pytest.mark.process
def test_arguments_name_the_file_or_switch_it_off(tmp_path: Path) -> None:
    run(tmp_path, "--ros-args", "--log-file-name", "mine", "--disable-stdout-logs")
    run(tmp_path, "--ros-args", "--disable-external-lib-logs")
    (name,) = logs(tmp_path)
    assert name.startswith(".ros/log/mine_")
    refused = run(tmp_path, "--ros-args", "--log-config-file", "x")
    assert "spdlog logging backend doesn't currently support external configuration" in refused.stderr


@pytest.mark.process
def test_a_folder_that_cannot_be_made_is_an_error_only_where_it_was_asked_for(tmp_path: Path) -> None:
    (tmp_path / "file").write_text("")
    asked = run(tmp_path, ROS_LOG_DIR=str(tmp_path / "file" / "x"))
    assert "RCLError: failed to initialize logging: Failed to create log directory" in asked.stderr
    unasked = run(tmp_path / "file")
    assert unasked.returncode == 0 and "loud" in unasked.stderr


def test_a_file_appears_with_its_first_line_and_another_one_after_it_was_closed(tmp_path: Path) -> None:
    file = LogFile("mine", 7, {"ROS_LOG_DIR": str(tmp_path / "deep" / "log")})
    assert file.enabled
    assert file.is_wanted
    assert not (tmp_path / "deep").exists()
    file.close()
    for line in ("one", "zwei \u00fc", "bad \udcff"):
        file.write(line)
    (name,) = logs(file.folder)
    assert re.fullmatch(r"mine_7_\d{13}\.log", name)
    assert (file.folder / name).read_text(encoding="utf-8") == "one\nzwei \u00fc\nbad \\udcff\n"
    file.open()
    assert logs(file.folder) == [name]
    file.close()
    file.close()
    assert file.enabled
    file.program = "other"
    file.write("two")
    assert [each.partition("_")[0] for each in logs(file.folder)] == ["mine", "other"]
    file.close()


def test_nothing_is_written_by_a_file_that_is_switched_off(tmp_path: Path) -> None:
    file = LogFile("mine", 7, {"ROS_HOME": str(tmp_path)})
    file.enabled = False
    file.write("one")
    assert logs(tmp_path) == []
    assert file.is_wanted
    assert not LogFile("mine", 7, {"HOME": str(tmp_path)}).is_wanted


def test_a_disk_that_takes_nothing_is_tried_once(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    tried: list[int] = []

    def full(descriptor: int, _line: bytes) -> int:
        tried.append(descriptor)
        raise OSError(28, "No space left on device")

    file = LogFile("mine", 7, {"ROS_LOG_DIR": str(tmp_path)})
    file.open()
    with monkeypatch.context() as patched:
        patched.setattr(os, "write", full)
        file.write("one")
        file.write("two")
    file.write("three")
    assert len(tried) == 1
    assert not file.enabled
    file.close()
    (name,) = logs(tmp_path)
    assert (tmp_path / name).read_bytes() == b""


def test_a_file_whose_descriptor_others_closed_is_given_up_quietly(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    file = LogFile("mine", 7, {"ROS_LOG_DIR": str(tmp_path)})
    file.open()
    closed: list[int] = []

    def fail(descriptor: int) -> None:
        closed.append(descriptor)
        raise OSError(9, "Bad file descriptor")

    with monkeypatch.context() as patched:
        patched.setattr(os, "close", fail)
        file.close()
        file.close()
    (descriptor,) = closed
    os.close(descriptor)
    assert not file.enabled
    file.write("lost")
    (name,) = logs(tmp_path)
    assert (tmp_path / name).read_bytes() == b""


@pytest.mark.parametrize(
    ("env", "folder"),
    [
        ({"ROS_LOG_DIR": "/a", "ROS_HOME": "/b", "HOME": "/h"}, "/a"),
        ({"ROS_LOG_DIR": "", "ROS_HOME": "/b", "HOME": "/h"}, "/b/log"),
        ({"HOME": "/h"}, "/h/.ros/log"),
        ({"ROS_LOG_DIR": "~", "HOME": "/h"}, "/h"),
        ({"ROS_LOG_DIR": "~/a", "HOME": "/h"}, "/h/a"),
        ({"ROS_HOME": "~/b", "HOME": "/h"}, "/h/b/log"),
        ({"ROS_LOG_DIR": "a~/b", "HOME": "/h"}, "a~/b"),
    ],
)
def test_the_logging_directory_follows_the_environment(env: dict[str, str], folder: str) -> None:
    assert logging_directory(env) == Path(folder)


def test_the_file_of_a_process_bears_its_programs_name_and_number(
    monkeypatch: pytest.MonkeyPatch, tmp_path: Path
) -> None:
    monkeypatch.setenv("ROS_LOG_DIR", str(tmp_path))
    for started, name in (
        (["/usr/bin/python3", "x.py"], "python3"),
        (["C/python.exe"], "python"),
        (["talker"], "talker"),
    ):
        monkeypatch.setattr(sys, "orig_argv", started)
        assert of_process().program == name
    monkeypatch.setattr(sys, "orig_argv", [])
    monkeypatch.setattr(sys, "executable", "")
    file = of_process()
    file.write("x")
    file.close()
    (name,) = logs(tmp_path)
    assert name.startswith(f"python3_{os.getpid()}_")
