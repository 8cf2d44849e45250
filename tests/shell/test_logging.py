"""What the log lines of programs in a terminal obey: its own environment."""

from __future__ import annotations

from typing import Any


def test_logging_obeys_the_environment_of_the_terminal(machine: Any) -> None:
    machine.run("mkdir -p logs; export RCUTILS_CONSOLE_OUTPUT_FORMAT='{severity}!{message}' ROS_LOG_DIR=~/logs")
    command = "timeout 0.5 ros2 run turtlesim turtlesim_node"
    shown = machine.run(command, seconds=1.0)
    assert shown.out == "" and shown.err.startswith("INFO!Starting turtlesim")
    assert machine.run("cat logs/turtlesim_node_*.log").out == shown.err
    moved = machine.run(f"RCUTILS_LOGGING_USE_STDOUT=1 RCUTILS_COLORIZED_OUTPUT=1 {command}", seconds=1.0)
    assert moved.err == "" and moved.out.startswith("\x1b[0mINFO!Starting")
