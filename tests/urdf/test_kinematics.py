"""Our own forward kinematics against yourdfpy's, and what a wheel must do."""

from __future__ import annotations

import io
import math
import random
from collections.abc import Callable

import pytest

from day6_urdf import parse_robot, shipped_model, yourdfpy_robot
from day6_urdf.kinematics import (
    about,
    canonical,
    compose,
    inverse,
    joint_transform,
    link_transforms,
    matrix,
    multiply,
    positions_with_mimics,
)
from day6_urdf.model import Pose, quaternion_from_rpy
from tests.support.folded import folded


@folded("seed", range(30))
def test_every_link_of_random_robots_stands_where_yourdfpy_puts_it(
    seed: int, random_description: Callable[..., str]
) -> None:
    choice = random.Random(1000 + seed)
    # yourdfpy looks up the position of a mimicked joint at the wrong place when a joint before it is floating or planar
    # (it counts joints where it should count degrees of freedom), so a robot has either mimics or those.
    simple = ("fixed", "continuous", "revolute", "prismatic")
    text = random_description(choice, kinds=simple) if seed % 2 else random_description(choice, mimics=False)
    robot = parse_robot(text)
    urdf = yourdfpy_robot.module().URDF.load(io.BytesIO(text.encode()), load_meshes=False)
    movers = [j.name for j in robot.joints if j.type in ("revolute", "continuous", "prismatic") and j.mimic is None]
    positions = {name: choice.uniform(-3, 3) for name in movers}
    urdf.update_cfg(positions)
    for link, transform in link_transforms(robot, positions).items():
        theirs = urdf.get_transform(link, robot.root)
        for row, their_row in zip(matrix(transform), theirs, strict=True):
            assert row == pytest.approx(list(their_row), abs=1e-9), link


def test_half_a_turn_of_a_wheel_turns_it_and_leaves_it_in_its_place() -> None:
    car = parse_robot(shipped_model())
    at = link_transforms(car, {"left_wheel_joint": math.pi / 2})
    assert at["left_wheel"].xyz == (0.0, 0.15, 0.05)
    # What pointed up (z) points forward (x) after a quarter turn about y.
    assert [row[2] for row in matrix(at["left_wheel"])[:3]] == pytest.approx([1, 0, 0], abs=1e-12)
    assert at["right_wheel"].rotation == (0.0, 0.0, 0.0, 1.0)
    assert at["caster"].xyz == (0.1, 0.0, 0.02)


def test_a_prismatic_axis_of_any_length_moves_a_metre_a_metre() -> None:
    text = (
        '<robot name="r"><link name="a"/><link name="b"/><joint name="j" type="prismatic"><parent link="a"/>'
        '<child link="b"/><axis xyz="0 0 5"/><limit upper="1" effort="1" velocity="1"/></joint></robot>'
    )
    assert joint_transform(parse_robot(text).joint("j"), 0.5).xyz == (0.0, 0.0, 0.5)


def test_a_mimic_of_a_mimic_follows_and_a_ring_of_mimics_ends() -> None:
    joint = '<joint name="{0}" type="continuous"><parent link="{1}"/><child link="{2}"/>{3}</joint>'
    links = "".join(f'<link name="{name}"/>' for name in "abcd")
    chain = joint.format("x", "a", "b", '<mimic joint="y" multiplier="2" offset="1"/>')
    chain += joint.format("y", "b", "c", '<mimic joint="z" multiplier="-1"/>')
    robot = parse_robot(f'<robot name="r">{links}{chain}{joint.format("z", "c", "d", "")}</robot>')
    assert positions_with_mimics(robot, {"z": 3.0}) == {"z": 3.0, "y": -3.0, "x": -5.0}
    links = "".join(f'<link name="{name}"/>' for name in "abc")
    ring = joint.format("x", "a", "b", '<mimic joint="y"/>') + joint.format("y", "a", "c", '<mimic joint="x"/>')
    robot = parse_robot(f'<robot name="r">{links}{ring}</robot>')
    assert positions_with_mimics(robot, {}) == {}


@pytest.mark.parametrize("seed", range(5))
def test_composing_with_the_inverse_gives_back_where_one_was(seed: int) -> None:
    choice = random.Random(seed)
    pose = Pose.from_rpy(*[tuple(choice.uniform(-3, 3) for _ in range(3)) for _ in range(2)])  # type: ignore[arg-type]
    back = compose(inverse(pose), pose)
    assert back.xyz == pytest.approx((0, 0, 0), abs=1e-12)
    assert abs(back.rotation[3]) == pytest.approx(1)
    assert Pose.from_rpy((0, 0, 0), pose.rpy).rotation == pytest.approx(pose.rotation, abs=1e-9) or Pose.from_rpy(
        (0, 0, 0), pose.rpy
    ).rotation == pytest.approx(tuple(-n for n in pose.rotation), abs=1e-9)


def test_quaternions_are_x_y_z_w() -> None:
    assert quaternion_from_rpy(0, 0, math.pi / 2) == pytest.approx((0, 0, math.sqrt(0.5), math.sqrt(0.5)))
    assert multiply(about((0, 0, 2), 1.0), about((0, 0, -1), 1.0)) == pytest.approx((0, 0, 0, 1))


@pytest.mark.parametrize(
    ("angle", "expected"),
    [
        (1.0, (0, math.sin(0.5), 0, math.cos(0.5))),
        (3.0, (0, math.sin(1.5), 0, math.cos(1.5))),
        (4.0, (0, math.sin(2.0), 0, math.cos(2.0))),  # w is negative: KDL keeps y positive while the trace is
        (4.1, (0, math.sin(2.05), 0, math.cos(2.05))),
        (4.3, (0, -math.sin(2.15), 0, -math.cos(2.15))),  # past 240 degrees the trace is positive again
        (6.0, (0, -math.sin(3.0), 0, -math.cos(3.0))),
    ],
)
def test_quaternions_have_the_sign_kdl_gives_them(angle: float, expected: tuple[float, ...]) -> None:
    assert canonical(about((0, 1, 0), angle)) == pytest.approx(expected)
