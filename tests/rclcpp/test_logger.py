"""Where the log messages of C++ programs say that they come from."""

from __future__ import annotations

import re
from collections.abc import Iterator
from pathlib import Path

import pytest
from rcl_interfaces.msg import Log

from day6_core.ros import programs
from tests.support.stepped_machine import SteppedMachine


@pytest.fixture
def logs() -> Iterator[list[Log]]:
    machine = SteppedMachine()
    heard: list[Log] = []
    machine.node.create_subscription(Log, "/rosout", heard.append, 100)
    machine.start("turtlesim", "turtlesim_node")
    machine.start("demo_nodes_py", "talker")
    machine.advance(1.5)
    yield heard
    machine.end()


def test_a_cpp_nodes_file_is_named_from_its_packages_folder_on(logs: list[Log]) -> None:
    log = next(log for log in logs if log.msg == "Starting turtlesim with node name /turtlesim")
    assert re.fullmatch(r"\./\w+\.py", log.file)
    source = Path(programs.__file__).parent / "turtlesim" / log.file
    # Nothing is invented: the file is there, and its line is the one that logs.
    assert "get_logger()" in source.read_text(encoding="utf-8").splitlines()[log.line - 1]


def test_a_python_nodes_file_is_a_whole_path_as_in_rclpy(logs: list[Log]) -> None:
    log = next(log for log in logs if log.name == "talker")
    assert Path(log.file).is_absolute() and Path(log.file).is_file()
