"""Covariances of poses: what is drawn of them is one standard deviation, turned as they are."""

from __future__ import annotations

import math
from typing import Any

import pytest
from geometry_msgs.msg import PoseWithCovarianceStamped
from nav_msgs.msg import Odometry

from day6_core.ros.programs.rviz2.model.displays.covariance import spread_of
from day6_core.ros.programs.rviz2.model.scene import CONE, CYLINDER, SPHERE, Shape, placed
from day6_urdf.kinematics import rotate
from tests.rviz2.rviz_machine import RVizMachine, lines

QUARTER = math.sqrt(0.5)


def covariance(**values: float) -> list[float]:
    """36 numbers; `xy=1` is the covariance of x and y."""
    names = ("x", "y", "z", "roll", "pitch", "yaw")
    numbers = [0.0] * 36
    for pair, value in values.items():
        first, _, second = pair.partition("_")
        row, column = names.index(first), names.index(second or first)
        numbers[6 * row + column] = numbers[6 * column + row] = value
    return numbers


def pose_of(machine: RVizMachine, numbers: list[float], *, turned: bool = False) -> list[Shape]:
    """The covariance's shapes around a pose at x = 2, which may be turned by a quarter about z."""
    message = PoseWithCovarianceStamped()
    message.header.frame_id = "map"
    message.pose.pose.position.x = 2.0
    turn = message.pose.pose.orientation
    turn.z, turn.w = (QUARTER, QUARTER) if turned else (0.0, 1.0)
    message.pose.covariance = numbers
    machine.publish("/here", message)
    return [each for each in machine.rviz.scene.shapes if each.colour[3] < 1]


@pytest.fixture
def display(machine: RVizMachine) -> Any:
    machine.open()
    machine.fix("map")
    machine.transform("map", "other")
    return machine.add("PoseWithCovariance", "/here")


def extent(shape: Shape, axis: tuple[float, float, float]) -> float:
    """How far a shape reaches along an axis of the world, for those whose axes lie along it."""
    own = [abs(sum(a * b for a, b in zip(rotate(shape.pose.rotation, unit), axis, strict=True))) for unit in UNITS]
    return sum(size * part for size, part in zip(shape.size, own, strict=True))


UNITS = ((1.0, 0.0, 0.0), (0.0, 1.0, 0.0), (0.0, 0.0, 1.0))


def test_a_ball_has_two_deviations_across_and_stays_in_the_frame_of_the_message(
    machine: RVizMachine, display: Any
) -> None:
    numbers = covariance(x=4.0, y=1.0, z=0.25, roll=0.1, pitch=0.1, yaw=0.1)
    (ball, *_) = pose_of(machine, numbers, turned=True)
    assert ball.kind == SPHERE and ball.pose.xyz == (2.0, 0.0, 0.0)
    assert [extent(ball, unit) for unit in UNITS] == pytest.approx([4.0, 2.0, 1.0])
    machine.rviz.edit(display.covariance.scale, 2.0)
    machine.settle()
    assert extent(pose_of(machine, numbers)[0], UNITS[0]) == pytest.approx(8.0)


def test_a_ball_lies_along_its_principal_axes(machine: RVizMachine, display: Any) -> None:
    (ball, *_) = pose_of(machine, covariance(x=1.0, y=1.0, x_y=0.99, z=0.01, roll=1.0))
    long = max(range(3), key=lambda index: ball.size[index])
    x, y, z = rotate(ball.pose.rotation, UNITS[long])
    assert (abs(x), abs(y), z) == (pytest.approx(QUARTER), pytest.approx(QUARTER), pytest.approx(0.0, abs=1e-9))
    assert x * y > 0 and ball.size[long] == pytest.approx(2 * math.sqrt(1.99))


def test_discs_on_the_axes_show_the_turn(machine: RVizMachine, display: Any) -> None:
    numbers = covariance(x=0.01, y=0.01, z=0.01, roll=0.04, pitch=0.01, yaw=0.0025)
    _, roll, pitch, yaw = pose_of(machine, numbers, turned=True)
    assert {each.kind for each in (roll, pitch, yaw)} == {CYLINDER}
    # On the axes of the pose, which is turned: its x is the map's y.
    assert roll.pose.xyz == pytest.approx((2.0, 1.0, 0.0)) and yaw.pose.xyz == pytest.approx((2.0, 0.0, 1.0))
    assert extent(roll, UNITS[1]) == pytest.approx(0.001, abs=1e-6)
    # The disc on the axis of yaw is as wide as roll and pitch let the axis lean: roll moves it along y, the map's x.
    leaning = sorted((2 * math.tan(0.2), 2 * math.tan(0.1)))
    assert sorted(yaw.size)[1:] == pytest.approx(leaning)
    machine.rviz.edit(display.covariance.frame, "Fixed")
    machine.rviz.edit(display.covariance.offset, 3.0)
    machine.rviz.edit(display.covariance.turn_scale, 2.0)
    machine.rviz.edit(display.covariance.style, "RGB")
    machine.settle()
    assert display.covariance.turn_colour.hidden
    _, roll, _, yaw = pose_of(machine, numbers, turned=True)
    assert roll.pose.xyz == pytest.approx((5.0, 0.0, 0.0)) and roll.colour == (1.0, 0.0, 0.0, 0.5)
    assert sorted(yaw.size)[2] == pytest.approx(3 * 2 * math.tan(0.4))
    machine.rviz.edit(display.covariance.turn, False)
    machine.settle()
    assert len(pose_of(machine, numbers)) == 1


def test_a_pose_on_the_ground_has_a_flat_ball_and_a_slice_for_its_heading(machine: RVizMachine, display: Any) -> None:
    ball, slice_ = pose_of(machine, covariance(x=0.25, y=0.25, yaw=0.01), turned=True)
    assert ball.size == pytest.approx((1.0, 1.0, 0.001)) and slice_.kind == CONE
    # From the pose forwards, wide at the end.
    assert placed(slice_.pose, (0.0, 0.0, 0.5)) == pytest.approx((2.0, 0.0, 0.0))
    assert placed(slice_.pose, (0.0, 0.0, -0.5)) == pytest.approx((2.0, 1.0, 0.0))
    assert extent(slice_, UNITS[0]) == pytest.approx(2 * math.tan(0.1))
    assert extent(slice_, UNITS[2]) == pytest.approx(0.001)


def test_what_is_no_covariance_is_not_drawn(machine: RVizMachine, display: Any) -> None:
    assert pose_of(machine, covariance()) == []
    assert pose_of(machine, covariance(x=-1.0)) == []
    assert spread_of([math.nan] * 36) is None
    numbers = covariance(x=1.0, yaw=1e12)
    assert all(math.isfinite(part) for each in pose_of(machine, numbers) for part in each.size)


def test_odometry_keeps_the_covariance_of_every_place(machine: RVizMachine) -> None:
    machine.open()
    machine.fix("map")
    machine.transform("map", "other")
    display = machine.add("Odometry", "/odom")
    for step in range(3):
        message = Odometry()
        message.header.frame_id = "map"
        message.pose.pose.position.x, message.pose.pose.orientation.w = float(step), 1.0
        message.pose.covariance = covariance(x=0.01 * (step + 1), y=0.01)
        machine.publish("/odom", message)
    balls = [each for each in machine.rviz.scene.shapes if each.kind == SPHERE]
    assert [ball.pose.xyz[0] for ball in balls] == [0.0, 1.0, 2.0]
    assert [extent(ball, UNITS[0]) for ball in balls] == pytest.approx([0.2, 2 * math.sqrt(0.02), 2 * math.sqrt(0.03)])
    message.pose.covariance[3] = math.nan
    machine.publish("/odom", message)
    assert lines(display)["Topic"] == ("Error", "Message contained invalid floating point values (nans or infs)")
