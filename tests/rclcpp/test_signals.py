"""C++ programs that are sent SIGINT and SIGTERM: what they say, how they end, and what `ros2 run` and `ros2 launch` make of it.

rclcpp's signal handler takes both and shuts the context down, so that main returns 0 (rclcpp/signal_handler.cpp). `ros2 run` has
no handler for SIGTERM, which the shell's `kill %1` sends to it as well as to its node.
"""

from __future__ import annotations

import os
import re
import signal
import subprocess
import sys
import threading
from collections.abc import Callable
from contextlib import suppress
from pathlib import Path
from typing import Any

import pytest

from day6_core.ros import distribution
from tests.support.waiting import PATIENCE, communicate, until

ROBOT = ("--ros-args", "-p", "robot_description:=<robot name='a'><link name='b'/></robot>")
PROGRAMS: dict[str, tuple[str, ...]] = {
    "turtlesim turtlesim_node": (),
    "demo_nodes_cpp talker": (),
    "demo_nodes_cpp add_two_ints_server": (),
    "lifecycle lifecycle_talker": (),
    "robot_state_publisher robot_state_publisher": ROBOT,
    "rclcpp_components component_container": (),
    "composition manual_composition": (),
    "tf2_ros static_transform_publisher": ("--frame-id", "a", "--child-frame-id", "b"),
    "image_tools cam2image": ("--ros-args", "-p", "burger_mode:=true"),
}
SAYS = r"\[INFO\] \[\d+\.\d{9}\] \[rclcpp\]: signal_handler\((.*)\)\n"


def said(text: str) -> list[str]:
    return re.findall(SAYS, text)


@pytest.mark.parametrize("program", PROGRAMS)
def test_both_signals_stop_a_program_with_one_line(machine: Any, program: str) -> None:
    for number, status in ((2, 0), (15, 143)):
        running = machine.start("run", *program.split(), *PROGRAMS[program])
        machine.step(1.0)
        running.program.send(number)
        machine.step(0.5)
        assert (running.status, said(running.stderr)) == (status, ["SIGINT/SIGTERM"]), running.stderr
        assert running.stderr.endswith("signal_handler(SIGINT/SIGTERM)\n") and "[ros2run]" not in running.stdout


def test_a_second_ctrl_c_changes_nothing(machine: Any) -> None:
    running = machine.start("run", "demo_nodes_cpp", "talker")
    machine.step(1.0)
    running.program.interrupt()
    running.program.interrupt()
    machine.step(0.5)
    assert (running.status, said(running.stderr)) == (0, ["SIGINT/SIGTERM"])


def test_a_container_takes_its_loaded_nodes_with_it(machine: Any) -> None:
    container = machine.start("run", "rclcpp_components", "component_container")
    for kind in ("Talker", "Listener"):
        machine.ros2("component", "load", "/ComponentManager", "composition", f"composition::{kind}")
    assert machine.ros2("node", "list").stdout.split() == ["/ComponentManager", "/listener", "/talker"]
    container.program.send(15)
    machine.step(0.5)
    assert said(container.stderr) == ["SIGINT/SIGTERM"]
    assert machine.ros2("node", "list").stdout == ""


@pytest.mark.parametrize("name", distribution.NAMES)
def test_the_newest_distribution_names_the_signal_and_warns_of_lifecycle_nodes(
    machine: Any, name: str, in_distribution: Callable[[str], None]
) -> None:
    in_distribution(name)
    for number in (2, 15):
        running = machine.start("run", "lifecycle", "lifecycle_talker")
        machine.step(0.1)
        running.program.send(number)
        machine.step(0.1)
        expected = f"signum={number}" if name in ("lyrical", "rolling") else "SIGINT/SIGTERM"
        assert said(running.stderr) == [expected]
        warned = "[rclcpp_lifecycle]: LifecycleNode is not shut down: Node still in state(1) in destructor\n"
        assert running.stderr.endswith(warned) == (name in ("kilted", "lyrical", "rolling"))


LAUNCH = """\
from launch import LaunchDescription
from launch.actions import ExecuteProcess, RegisterEventHandler
from launch.event_handlers import OnProcessIO
from launch.actions import EmitEvent
from launch.events.process import SignalProcess
from launch.events import matches_action
from launch_ros.actions import Node
import signal


def generate_launch_description():
    talker = Node(package='demo_nodes_cpp', executable='talker')
    stop = EmitEvent(event=SignalProcess(signal_number=signal.SIGTERM, process_matcher=matches_action(talker)))
    first = OnProcessIO(target_action=talker, on_stderr=lambda event: stop if b'World: 1' in event.text else None)
    return LaunchDescription([talker, RegisterEventHandler(first)])
"""


@pytest.mark.process
@pytest.mark.skipif(os.name == "nt", reason="sends SIGTERM to a process")
def test_a_launched_program_that_is_sent_sigterm_has_finished_cleanly(tmp_path: Path) -> None:
    (tmp_path / "stop.launch.py").write_text(LAUNCH, encoding="utf-8")
    done = communicate(_real("launch", "stop.launch.py", cwd=tmp_path))[0]
    assert "sending signal 'SIGTERM' to process[talker-1]" in done
    assert "signal_handler(SIGINT/SIGTERM)" in done
    assert "[INFO] [talker-1]: process has finished cleanly [pid " in done


@pytest.mark.process
@pytest.mark.skipif(os.name == "nt", reason="sends signals to a process")
@pytest.mark.parametrize(("signals", "status"), [([2], 0), ([2, 2], 0), ([15], 143)])
def test_in_a_real_terminal_it_is_the_same(tmp_path: Path, signals: list[int], status: int) -> None:
    process = _real("run", "demo_nodes_cpp", "talker", cwd=tmp_path)
    assert process.stdout is not None
    lines = []
    for line in process.stdout:
        lines.append(line)
        if "World: 1" in line:
            for number in signals:
                process.send_signal(signal.Signals(number))
    assert process.wait() % 256 == status, lines
    assert said("".join(lines)) == ["SIGINT/SIGTERM"]


def _real(*words: str, cwd: Path) -> subprocess.Popen[str]:
    """Start `ros2 WORDS…` as a process; it is killed when it does not end."""
    code = "import sys; from day6_tui.main import main; sys.exit(main())"
    process = subprocess.Popen(
        [sys.executable, "-c", code, "ros2", *words],
        cwd=cwd,
        env={**os.environ, "ROS_LOG_DIR": str(cwd / "log")},
        stdin=subprocess.DEVNULL,
        stdout=subprocess.PIPE,
        stderr=subprocess.STDOUT,
        text=True,
        start_new_session=True,
    )
    threading.Thread(target=_kill_at_last, args=(process,), daemon=True).start()
    return process


def _kill_at_last(process: subprocess.Popen[str]) -> None:
    with suppress(AssertionError):
        until(lambda: process.poll() is not None, 2 * PATIENCE, every=0.2)
    process.kill()
