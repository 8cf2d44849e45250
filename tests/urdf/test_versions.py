"""URDF 1.1 and 1.2: capsules, quaternions and wider limits, in the words of urdfdom 5.1 and 6.0, and what older ones say."""

from __future__ import annotations

import math

import pytest

from day6_urdf import Report, check_text, load_robot
from day6_urdf.model import Capsule, Limit, Pose
from day6_urdf.topview.plan import plan_top

NEWEST = (1, 2)


def of_version(version: str, body: str, newest: tuple[int, int] = NEWEST) -> Report:
    return check_text(f'<robot name="r" version="{version}">{body}</robot>', newest)


def limited(version: str, limit: str, kind: str = "revolute") -> Report:
    joint = f'<joint name="j" type="{kind}"><parent link="a"/><child link="b"/><limit {limit}/></joint>'
    return of_version(version, f'<link name="a"/><link name="b"/>{joint}')


def visual(shape: str, origin: str = "") -> str:
    return f'<link name="a"><visual>{origin}<geometry>{shape}</geometry></visual></link>'


def said_of(report: Report) -> list[str]:
    return [each.text for each in report.diagnostics]


def test_a_capsule_and_a_quaternion_are_urdf_1_1() -> None:
    capsule = visual('<capsule radius="0.1" length="0.4"/>', '<origin xyz="1 2 3" quat_xyzw="0 0 2 2"/>')
    report = of_version("1.1", capsule)
    assert report.robot is not None and not report.diagnostics
    (shown,) = report.robot.links[0].visuals
    assert shown.geometry == Capsule(0.1, 0.4)
    assert shown.origin.xyz == (1.0, 2.0, 3.0) and shown.origin.rpy[2] == pytest.approx(math.pi / 2)
    assert load_robot(f'<robot name="r" version="1.1">{capsule}</robot>', NEWEST) == report.robot
    ignored = of_version("1.0", capsule)
    assert ignored.robot is not None and not ignored.robot.links[0].visuals
    assert said_of(ignored) == [
        "Ignoring quat_xyzw attribute requiring URDF version 1.1 since specified version is 1.0.",
        "Ignoring capsule attribute minimum required version URDF version 1.1 since specified version is 1.0.",
        "Could not parse visual element for Link [a]",
    ]


@pytest.mark.parametrize(
    ("body", "said"),
    [
        (visual('<capsule length="1"/>'), "Capsule shape must have both length and radius attributes"),
        (visual('<capsule length="1" radius="x"/>'), "radius [x] is not a valid float"),
        (
            visual('<box size="1 1 1"/>', '<origin rpy="0 0 0" quat_xyzw="0 0 0 1"/>'),
            "Both rpy and quat_xyzw orientations are defined. Use either one or the other.",
        ),
        (
            visual('<box size="1 1 1"/>', '<origin quat_xyzw="0 0 1"/>'),
            "Parser found 3 elements but 4 expected while parsing vector [0 0 1]",
        ),
    ],
)
def test_what_is_wrong_with_a_capsule_or_quaternion_is_told(body: str, said: str) -> None:
    assert said_of(of_version("1.2", body)) == [said, "Could not parse visual element for Link [a]"]


def test_an_older_urdfdom_knows_neither() -> None:
    """That of Humble, Jazzy and Kilted: the version is refused, the shape unknown, the attribute passed over."""
    (refused,) = said_of(check_text('<robot name="r" version="1.1"><link name="a"/></robot>'))
    assert refused == "Invalid 'version' specified; only version 1.0 is currently supported"
    capsule = visual('<capsule radius="1" length="1"/>')
    assert said_of(of_version("1.0", capsule, (1, 0)))[0] == "Unknown geometry type 'capsule'"
    turned = visual('<sphere radius="1"/>', '<origin quat_xyzw="0 0 1 0"/>')
    report = of_version("1.0", turned, (1, 0))
    assert report.robot is not None and not report.diagnostics
    assert report.robot.links[0].visuals[0].origin == Pose()


@pytest.mark.parametrize(
    ("version", "limit", "kind", "said"),
    [
        ("1.2", 'lower="-1" upper="1"', "revolute", ""),
        ("1.2", "", "continuous", ""),
        ("1.2", 'lower="0" upper="1" jerk="x"', "prismatic", "joint [j]: jerk value (x) is not a valid float"),
        ("1.2", 'lower="0" upper="1" effort="-1"', "revolute", "joint [j]: effort value (-1) is negative"),
        (
            "1.2",
            'upper="1"',
            "revolute",
            (
                "joint [j]: revolute and prismatic joints must have both lower and upper position limits specified in URDF "
                "version 1.2 or later"
            ),
        ),
        (
            "1.2",
            'lower="1" upper="0"',
            "prismatic",
            "joint [j]: upper position limit (0.000000) cannot be smaller than lower position limit (1.000000)",
        ),
        ("1.1", 'lower="0" upper="1"', "revolute", "joint [j]: limit has no effort"),
        (
            "1.0",
            'effort="1" velocity="1" jerk="2"',
            "revolute",
            "joint [j]: Ignoring jerk attribute. Required atleast URDF version 1.2, but the specified version is 1.0.",
        ),
        ("1.3", "", "continuous", "Invalid 'version' specified; versions 1.0 to 1.2 are currently supported"),
    ],
)
def test_limits_by_version(version: str, limit: str, kind: str, said: str) -> None:
    assert said_of(limited(version, limit, kind))[:1] == ([said] if said else [])


def test_limits_of_urdf_1_2_are_wider() -> None:
    robot = limited("1.2", 'lower="-1" upper="1" acceleration="10" jerk="200"').robot
    assert robot is not None
    assert robot.joint("j").limit == Limit(-1.0, 1.0, math.inf, math.inf, 10.0, 10.0, 200.0)
    robot = limited("1.2", "", "continuous").robot
    assert robot is not None and robot.joint("j").limit == Limit(-math.inf, math.inf, math.inf, math.inf)


def test_a_capsule_is_seen_from_above_with_its_round_ends() -> None:
    robot = of_version("1.1", visual('<capsule radius="0.1" length="0.4"/>', '<origin quat_xyzw="0 1 0 1"/>')).robot
    assert robot is not None
    assert plan_top(robot).bounds == pytest.approx((-0.3, -0.1, 0.3, 0.1))
    upright = of_version("1.1", visual('<capsule radius="0.1" length="0.4"/>')).robot
    assert upright is not None and plan_top(upright).bounds == pytest.approx((-0.1, -0.1, 0.1, 0.1))
