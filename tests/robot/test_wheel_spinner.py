"""wheel_spinner: 50 messages a second, 0.02 rad apart, from 0 to 2 pi and round again."""

from __future__ import annotations

import math
from itertools import pairwise
from typing import TYPE_CHECKING

import pytest
from sensor_msgs.msg import JointState

if TYPE_CHECKING:
    from tests.robot.conftest import Machine


def test_it_turns_both_wheels_by_a_fiftieth_every_fiftieth_of_a_second(machine: Machine) -> None:
    heard = machine.watch(JointState, "/joint_states")
    running = machine.start("day6_bot", "wheel_spinner")
    machine.advance(1.0)
    assert len(heard) == 50
    assert [list(message.name) for message in heard] == [["left_wheel_joint", "right_wheel_joint"]] * 50
    assert [message.position[0] for message in heard] == pytest.approx([0.02 * step for step in range(1, 51)])
    assert all(message.position[0] == message.position[1] for message in heard)
    first, last = (message.header.stamp for message in (heard[0], heard[-1]))
    assert (last.sec - first.sec) * 10**9 + last.nanosec - first.nanosec == 980_000_000
    assert running.errors == (
        "[INFO] [wheel_spinner]: Turning left_wheel_joint, right_wheel_joint by 0.02 rad every 0.02 s\n"
    )


def test_the_angle_never_reaches_two_pi(machine: Machine) -> None:
    heard = machine.watch(JointState, "/joint_states")
    running = machine.start("day6_bot", "wheel_spinner")
    machine.advance(13.0)
    angles = [message.position[0] for message in heard]
    assert 6.26 < max(angles) < 2 * math.pi
    assert sum(b < a for a, b in pairwise(angles)) == 2
    assert running.errors.splitlines()[1:] == [f"[INFO] [wheel_spinner]: Turn {turn} finished" for turn in (1, 2)]


def test_names_and_step_are_parameters_so_that_the_usual_mistakes_can_be_made(machine: Machine) -> None:
    heard = machine.watch(JointState, "/joint_states")
    machine.start("day6_bot", "wheel_spinner", "--ros-args", "-p", "joints:=[wheel_left_joint]", "-p", "step:=-0.1")
    machine.advance(0.1)
    assert list(heard[-1].name) == ["wheel_left_joint"]
    assert list(heard[-1].position) == pytest.approx([2 * math.pi - 0.5])


def test_ctrl_c_ends_it_and_its_node(machine: Machine) -> None:
    running = machine.start("day6_bot", "wheel_spinner")
    running.program.interrupt()
    machine.advance(0.1)
    assert running.program.status == 130
    assert "wheel_spinner" not in machine.node.get_node_names()
