"""Effort: arcs around revolute joints, as large as the effort is of the greatest one."""

from __future__ import annotations

import math
from typing import Any

import pytest
from sensor_msgs.msg import JointState

from day6_tui.locale import Texts
from day6_tui.windows.rviz.describing import described
from tests.rviz2.rviz_machine import RVizMachine, lines

ARM = """<robot name="arm"><link name="base"/><link name="arm"/><link name="wheel"/><link name="free"/>
<joint name="shoulder" type="revolute"><parent link="base"/><child link="arm"/><axis xyz="0 0 1"/>
<limit lower="-1" upper="1" effort="10" velocity="1"/></joint>
<joint name="axle" type="continuous"><parent link="base"/><child link="wheel"/><axis xyz="0 1 0"/>
<limit effort="5" velocity="1"/></joint>
<joint name="loose" type="continuous"><parent link="base"/><child link="free"/><axis xyz="0 1 0"/></joint></robot>"""


def state(effort: float, name: str = "shoulder") -> JointState:
    message = JointState(name=[name, "unknown"], effort=[effort, 1.0])
    message.header.frame_id = "base"
    return message


@pytest.fixture
def display(machine: RVizMachine) -> Any:
    machine.open()
    machine.fix("base")
    machine.transform("base", "arm", (1.0, 0.0, 0.0))
    for grid in machine.rviz.displays:
        machine.do(lambda grid=grid: machine.rviz.remove_display(grid))
    return machine.add("Effort", "/joint_states")


def radius(machine: RVizMachine) -> float:
    return max(math.hypot(x, y) for x, y, _ in machine.rviz.scene.lines[-1].vertices)


def test_the_arc_grows_with_the_effort_up_to_the_limit(machine: RVizMachine, display: Any) -> None:
    machine.publish("/joint_states", state(5.0))
    assert lines(display)["Process message"] == ("Error", "Robot model might not be loaded yet")
    machine.describe(ARM)
    assert lines(display)["URDF"] == ("Ok", "Robot model parsed Ok")
    assert [each.name for each in display.joints.children] == ["axle", "shoulder"]
    assert "Joint 'loose' has no <limit> tag in URDF. Effort plugin needs to know the effort" in machine.running.errors
    machine.publish("/joint_states", state(5.0))
    assert radius(machine) == pytest.approx(0.05 + 0.5 * (0.5 + 0.05))
    assert machine.rviz.scene.lines[-1].pose.xyz == (1.0, 0.0, 0.0)
    assert display.child("Joints", "shoulder", "Effort").value == 5.0
    first = machine.rviz.scene.lines[-1].vertices[1][0]
    assert first > 0
    machine.publish("/joint_states", state(-50.0))
    assert radius(machine) == pytest.approx(0.05 + 0.5 * (1.0 + 0.05))
    assert machine.rviz.scene.lines[-1].vertices[1][0] < 0
    # Red from the limit on.
    assert machine.rviz.scene.lines[-1].colours[0] == (1.0, 0.0, 0.0, 1.0)
    assert len(machine.rviz.scene.lines) == 1
    # A wheel has no arc in the original either.
    machine.publish("/joint_states", state(5.0, "axle"))
    assert not machine.rviz.scene.lines


def test_what_cannot_be_shown_is_told(machine: RVizMachine, display: Any) -> None:
    machine.describe(ARM)
    short = state(1.0)
    short.effort = [1.0]
    machine.publish("/joint_states", short)
    text = "Received a joint state msg with different joint names and efforts size!"
    assert lines(display)["Topic"] == ("Error", text)
    machine.publish("/joint_states", state(math.nan))
    assert lines(display)["shoulder"] == ("Error", "Invalid effort: nan")
    machine.rviz.edit(display.prefix, "left")
    machine.settle()
    machine.publish("/joint_states", state(1.0))
    text = "Error transforming from frame 'left/arm' to frame 'base'"
    assert lines(display)["shoulder"] == ("Error", text)
    machine.describe("<robot/>")
    assert lines(display)["URDF"] == ("Error", "Unable to parse robot model description!")


def test_joint_states_without_a_frame_are_dropped_as_by_the_original_and_that_is_told(
    machine: RVizMachine, display: Any
) -> None:
    machine.describe(ARM)
    message = state(5.0)
    message.header.frame_id = ""  # as joint_state_publisher sends them
    machine.publish("/joint_states", message)
    assert not machine.rviz.scene.lines
    dropped = (
        "Message Filter dropping message: frame '' at time 0.000 for reason 'the frame id of the message is empty'"
    )
    assert machine.running.errors.count(dropped) == 1
    assert "Effort: 1 messages without a frame in their header" in described(machine.rviz, Texts("en"))


def test_a_joint_that_is_switched_off_stays_so_in_the_file(machine: RVizMachine, display: Any) -> None:
    machine.describe(ARM)
    machine.rviz.edit(display.child("Joints", "shoulder"), False)
    machine.settle()
    machine.publish("/joint_states", state(5.0))
    assert not machine.rviz.scene.lines
    copy = machine.do(lambda: machine.rviz.duplicate_display(display))
    machine.settle()
    assert copy.child("Joints", "shoulder").value is False
