"""As much of tf2 as a picture needs."""

from __future__ import annotations

import math

import pytest
from geometry_msgs.msg import TransformStamped

from day6_core.ros.programs.day6_bot._frames import RobotFrames
from day6_core.ros.programs.day6_bot._joints import JointReadings, Moment
from day6_core.ros.programs.day6_bot._status import nearest_name
from day6_urdf.kinematics import IDENTITY


def stamped(parent: str, child: str, x: float = 0.0, yaw: float = 0.0) -> TransformStamped:
    message = TransformStamped(child_frame_id=child)
    message.header.frame_id = parent
    message.transform.translation.x = x
    message.transform.rotation.z, message.transform.rotation.w = math.sin(yaw / 2), math.cos(yaw / 2)
    return message


def test_transforms_are_chained_up_and_down() -> None:
    frames = RobotFrames()
    frames.update(
        [stamped("odom", "base", 1.0, math.pi / 2), stamped("base", "wheel", 2.0), stamped("odom", "other", 5.0)]
    )
    wheel = frames.lookup("odom", "wheel")
    assert wheel is not None and wheel.xyz == pytest.approx((1.0, 2.0, 0.0))
    back = frames.lookup("wheel", "other")
    assert back is not None and back.xyz == pytest.approx((-2.0, -4.0, 0.0))
    assert frames.lookup("x", "x") == IDENTITY


def test_what_nothing_connects_has_no_transform() -> None:
    frames = RobotFrames()
    frames.update([stamped("a", "b"), stamped("c", "d")])
    assert frames.lookup("a", "d") is None
    assert frames.lookup("a", "nowhere") is None


def test_a_loop_of_frames_does_not_hang() -> None:
    frames = RobotFrames()
    frames.update([stamped("a", "b"), stamped("b", "a"), stamped("c", "c")])
    assert frames.lookup("z", "a") is None
    assert frames.lookup("c", "a") is None


def test_the_same_transform_again_is_no_news() -> None:
    frames = RobotFrames()
    assert frames.update([stamped("/a", "/b", 1.0)])
    assert not frames.update([stamped("a", "b", 1.0)])
    assert frames.update([stamped("a", "b", 2.0)])


def hear(readings: JointReadings, *moments: tuple[float, float], turning: bool = True) -> float:
    for seconds, position in moments:
        now_ns = int(seconds * 1e9)
        readings.hear(["j"], [position], Moment(now_ns, now_ns), frozenset(["j"] if turning else []))
    return readings.readings(frozenset(["j"]))[0].speed


def test_the_jump_from_two_pi_to_zero_is_no_jump_in_speed() -> None:
    assert hear(JointReadings(), *[(n * 0.02, (6.0 + n * 0.02) % (2 * math.pi)) for n in range(30)]) == pytest.approx(1)


def test_metres_do_not_wrap() -> None:
    assert hear(JointReadings(), (0.0, 0.0), (1.0, 7.0), turning=False) == pytest.approx(7.0)


def test_who_falls_silent_stands_still_and_is_forgotten_in_the_end() -> None:
    readings = JointReadings()
    assert hear(readings, (0.0, 0.0), (0.5, 1.0)) == pytest.approx(2.0)
    assert readings.heard_lately(1_000_000_000) == ("j",)
    readings.forget_silent(2_000_000_000)
    assert readings.readings(frozenset())[0].speed == 0.0
    assert readings.heard_lately(2_000_000_000) == ()
    readings.forget_silent(20_000_000_000)
    assert readings.readings(frozenset()) == ()


@pytest.mark.parametrize(
    ("name", "meant"),
    [
        ("wheel_left_joint", "left_wheel_joint"),
        ("left_wheel_jont", "left_wheel_joint"),
        ("leftwheeljoint", "left_wheel_joint"),
        ("elbow", None),
    ],
)
def test_the_name_that_was_meant_is_found(name: str, meant: str | None) -> None:
    assert nearest_name(name, ["left_wheel_joint", "right_wheel_joint"]) == meant
