"""draw_square and mimic together with turtlesim_node."""

from __future__ import annotations

from typing import TYPE_CHECKING

import pytest
from geometry_msgs.msg import Twist
from turtlesim.msg import Pose
from turtlesim.srv import Spawn

if TYPE_CHECKING:
    from tests.turtlesim.conftest import Machine


def test_draw_square_resets_and_drives_corner_after_corner(machine: Machine) -> None:
    turtlesim = machine.start("turtlesim_node")
    machine.ticks(2)
    square = machine.start("draw_square")
    machine.advance(7.0)
    assert turtlesim.log[2:] == [
        "[INFO] [turtlesim]: Resetting turtlesim.",
        "[INFO] [turtlesim]: Spawning turtle [turtle1] at x=[5.544445], y=[5.544445], theta=[0.000000]",
    ]
    assert square.log[0] == "[INFO] [draw_square]: New goal [7.544445 5.544445, 0.000000]"
    assert square.log[1] == "[INFO] [draw_square]: Reached goal"
    assert square.log.count("[INFO] [draw_square]: Reached goal") == 2
    heading = float(square.log[-1].rpartition(", ")[2].rstrip("]"))
    assert heading == pytest.approx(1.5708, abs=0.02)


def test_draw_square_waits_for_the_first_pose(machine: Machine) -> None:
    square = machine.start("draw_square")
    twists = machine.watch(Twist, "/turtle1/cmd_vel")
    machine.advance(1.0)
    assert square.log == []
    assert twists == []


def test_mimic_turns_driving_backward_into_driving_forward(machine: Machine) -> None:
    machine.start("turtlesim_node")
    machine.ticks(1)
    machine.call(Spawn, "/spawn", x=5.0, y=2.0, name="turtle2")
    machine.start("mimic", "--ros-args", "-r", "input/pose:=turtle1/pose", "-r", "output/cmd_vel:=turtle2/cmd_vel")
    first = machine.watch(Pose, "/turtle1/pose")
    second = machine.watch(Pose, "/turtle2/pose")
    command = Twist()
    command.linear.x, command.angular.z = -2.0, 0.5
    machine.node.create_publisher(Twist, "/turtle1/cmd_vel", 10).publish(command)
    machine.advance(0.3)
    assert first[-1].x < 5.3
    assert second[-1].x > 5.3
    assert first[-1].theta > 0
    assert second[-1].theta > 0


@pytest.mark.parametrize("executable", ["mimic", "draw_square"])
def test_ctrl_c_ends_a_tutorial_node(machine: Machine, executable: str) -> None:
    program = machine.start(executable)
    program.program.interrupt()
    machine.advance()
    assert program.program.status == 0
    assert program.log == ["[INFO] [rclcpp]: signal_handler(SIGINT/SIGTERM)"]


@pytest.mark.parametrize(
    ("executable", "node"),
    [("mimic", "turtle_mimic"), ("draw_square", "draw_square"), ("turtlesim_node", "turtlesim")],
)
def test_nodes_have_their_real_names_and_listen_to_parameter_events(
    machine: Machine, executable: str, node: str
) -> None:
    machine.start(executable)
    heard = dict(machine.node.get_subscriber_names_and_types_by_node(node, "/"))
    assert "/parameter_events" in heard
