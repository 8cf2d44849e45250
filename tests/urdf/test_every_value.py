"""Each number of a description: read into its own field, refused in urdfdom's words and with the line of its source."""

from __future__ import annotations

import itertools
import math
import random
from collections.abc import Callable

import pytest

from day6_urdf import check_text, parse_robot, yourdfpy_robot
from day6_urdf.advice import advice_of
from day6_urdf.kinematics import about, canonical, compose, joint_transform, matrix, multiply, rotate
from day6_urdf.model import (
    Box,
    Calibration,
    Cylinder,
    Dynamics,
    Inertial,
    Joint,
    Limit,
    Mesh,
    Mimic,
    Pose,
    Robot,
    Safety,
    Sphere,
    quaternion_from_rpy,
)
from day6_urdf.xmlreader import Element, XmlError, read_xml, write_xml
from tests.support.folded import folded

MODEL, LINK, JOINT, POSE = (f"./urdf_parser/src/{name}.cpp" for name in ("model", "link", "joint", "pose"))


def joint_text(inside: str, kind: str = "continuous") -> str:
    return (
        '<robot name="r"><link name="a"/><link name="b"/>'
        f'<joint name="j" type="{kind}"><parent link="a"/><child link="b"/>{inside}</joint></robot>'
    )


def link_text(inside: str) -> str:
    return f'<robot name="r"><link name="a">{inside}</link></robot>'


def first_message(text: str) -> tuple[str, str]:
    """What is said first, and where in urdfdom."""
    said, place = check_text(text).text.splitlines()[:2]
    return said.removeprefix("Error:").strip(), place.strip()


def joint_of(inside: str, kind: str = "continuous") -> Joint:
    return parse_robot(joint_text(inside, kind)).joint("j")


# -- joints ------------------------------------------------------------------------------------------------------------

PARTS = {
    "limit": ({"lower": 112, "upper": 128, "effort": 144, "velocity": 160}, 454, "Could not parse limit element for joint [j]"),
    "safety_controller": (
        {"soft_lower_limit": 184, "soft_upper_limit": 201, "k_position": 218, "k_velocity": 234},
        477,
        "Could not parse safety element for joint [j]",
    ),
    "calibration": ({"rising": 258, "falling": 275}, 490, "Could not parse calibration element for joint  [j]"),
    "mimic": ({"multiplier": 311, "offset": 329}, 503, "Could not parse mimic element for joint  [j]"),
    "dynamics": ({"damping": 65, "friction": 81}, 516, "Could not parse joint_dynamics element for joint [j]"),
}  # fmt: skip
NEEDED = {"mimic": ' joint="x"'}
ATTRIBUTES = [(tag, name) for tag, (names, _, _) in PARTS.items() for name in names]


@pytest.mark.parametrize(("tag", "wrong"), ATTRIBUTES)
def test_a_number_of_a_joint_that_is_none_is_named_with_its_line(tag: str, wrong: str) -> None:
    names, part_line, part_text = PARTS[tag]
    values = " ".join(f'{name}="{"1.x" if name == wrong else "1"}"' for name in names)
    report = check_text(joint_text(f"<{tag}{NEEDED.get(tag, '')} {values}/>"))
    assert report.robot is None
    assert report.text.splitlines()[:4] == [
        f"Error:   {wrong} value (1.x) is not a valid float",
        f"         at line {names[wrong]} in {JOINT}",
        f"Error:   {part_text}",
        f"         at line {part_line} in {JOINT}",
    ]


@pytest.mark.parametrize(
    ("inside", "text", "line"),
    [
        ('<limit velocity="1"/>', "joint limit: no effort", 136),
        ('<limit effort="1"/>', "joint limit: no velocity", 152),
        ("<safety_controller/>", "joint safety: no k_velocity", 226),
        ('<axis xyz="1 2"/>', "Malformed axis element for joint [j]: Parser found 2 elements", 440),
        ('<origin rpy="1 2"/>', "Parser found 2 elements but 3 expected while parsing vector [1 2]", 116),
    ],
)
def test_what_a_joint_lacks_is_named_with_its_line(inside: str, text: str, line: int) -> None:
    said, place = first_message(joint_text(inside))
    assert said.startswith(text) and place.startswith(f"at line {line} in ")


@pytest.mark.parametrize(
    ("text", "said", "line"),
    [
        ('<joint type="fixed"/>', "unnamed joint found", 345),
        ('<joint name="j"/>', "joint [j] has no type, check to see if it's a reference.", 401),
        (joint_text("", "prismatic"), "Joint [j] is of type PRISMATIC without limits", 466),
    ],
)
def test_a_joint_needs_a_name_a_type_and_limits(text: str, said: str, line: int) -> None:
    whole = text if text.startswith("<robot") else f'<robot name="r"><link name="a"/>{text}</robot>'
    assert first_message(whole) == (said, f"at line {line} in {JOINT}")


def test_every_number_of_a_joint_has_its_own_field() -> None:
    joint = joint_of(
        '<origin xyz="1 2 3" rpy="0 0 1"/><axis xyz="4 5 6"/><limit lower="7" upper="8" effort="9" velocity="10"/>'
        '<safety_controller soft_lower_limit="11" soft_upper_limit="12" k_position="13" k_velocity="14"/>'
        '<calibration rising="15" falling="16"/><mimic joint="m" multiplier="17" offset="18"/>'
        '<dynamics damping="19" friction="20"/>'
    )
    assert joint.origin == Pose((1.0, 2.0, 3.0), quaternion_from_rpy(0, 0, 1)) and joint.axis == (4.0, 5.0, 6.0)
    assert joint.limit == Limit(7.0, 8.0, 9.0, 10.0)
    assert joint.safety == Safety(11.0, 12.0, 13.0, 14.0)
    assert joint.calibration == Calibration(15.0, 16.0)
    assert joint.mimic == Mimic("m", 17.0, 18.0)
    assert joint.dynamics == Dynamics(19.0, 20.0)


def test_what_a_joint_does_not_say_has_urdfs_defaults() -> None:
    joint = joint_of(
        '<limit effort="1" velocity="2"/><safety_controller k_velocity="3"/><calibration/><mimic joint="m"/>'
    )
    assert (joint.origin, joint.axis, joint.dynamics) == (Pose(), (1.0, 0.0, 0.0), None)
    assert joint.limit == Limit(0.0, 0.0, 1.0, 2.0) and joint.safety == Safety(0.0, 0.0, 0.0, 3.0)
    assert joint.calibration == Calibration(None, None) and joint.mimic == Mimic("m", 1.0, 0.0)
    assert joint_of("<axis/>").axis == (0.0, 0.0, 0.0)
    for kind in ("fixed", "floating"):
        assert joint_of('<axis xyz="0 1 0"/>', kind).axis == (0.0, 0.0, 0.0)
    assert joint_of('<axis xyz="0 1 0"/>', "planar").axis == (0.0, 1.0, 0.0)
    assert joint_of('<dynamics damping="1"/>').dynamics == Dynamics(1.0, 0.0)
    assert joint_of('<dynamics friction="1"/>').dynamics == Dynamics(0.0, 1.0)


# -- links -------------------------------------------------------------------------------------------------------------

INERTIA = 'ixx="1" ixy="2" ixz="3" iyy="4" iyz="5" izz="6"'


def shape(text: str) -> str:
    return link_text(f"<visual><geometry>{text}</geometry></visual>")


@folded(
    "text, said, line",
    [
        (shape("<sphere/>"), "Sphere shape must have a radius attribute", 117),
        (shape('<sphere radius="x"/>'), "radius [x] is not a valid float", 126),
        (shape("<box/>"), "Box shape has no size attribute", 140),
        (
            shape('<box size="1 2"/>'),
            "Parser found 2 elements but 3 expected while parsing vector [1 2]",
            150,
        ),
        (shape('<cylinder length="1"/>'), "Cylinder shape must have both length and radius attributes", 164),
        (shape('<cylinder length="x" radius="1"/>'), "length [x] is not a valid float", 173),
        (shape('<cylinder length="1" radius="x"/>'), "radius [x] is not a valid float", 182),
        (shape("<mesh/>"), "Mesh must contain a filename attribute", 196),
        (shape("<cone/>"), "Unknown geometry type 'cone'", 262),
        (link_text("<inertial/>"), "Inertial element must have a mass element", 284),
        (link_text("<inertial><mass/></inertial>"), "Inertial: mass element must have value attribute", 289),
        (link_text('<inertial><mass value="x"/></inertial>'), "Inertial: mass [x] is not a float", 299),
        (link_text('<inertial><mass value="1"/></inertial>'), "Inertial element must have inertia element", 306),
        *(
            (
                link_text(f'<inertial><mass value="1"/><inertia {INERTIA.replace(f"{name}=", f"x{name}=")}/></inertial>'),
                f"Inertial: inertia element missing {name} attribute",
                325,
            )
            for name in ("ixx", "ixy", "ixz", "iyy", "iyz", "izz")
        ),
        (
            link_text(f'<inertial><mass value="1"/><inertia {INERTIA.replace("4", "x")}/></inertial>'),
            "Inertial: inertia element iyy is not a valid double",
            334,
        ),
        ('<robot name="r"><link/></robot>', "No name given for the link.", 423),
        (
            link_text('<visual><geometry><sphere radius="1"/></geometry><material/></visual>'),
            "Visual material must contain a name attribute",
            375,
        ),
        ('<robot name="r"><material/><link name="a"/></robot>', "Material must contain a name attribute", 64),
        (
            '<robot name="r"><material name="m"/><link name="a"/></robot>',
            "Material [m] color has no rgba",
            101,
        ),
        (
            '<robot name="r"><material name="m"><color rgba="1 0 0 2"/></material><link name="a"/></robot>',
            ("Material [m] has malformed color rgba values: "
            "Unable to parse component [2] to a double (while parsing a color value)"),
            93,
        ),
    ],
)  # fmt: skip
def test_what_is_wrong_with_a_link_is_said_with_its_line(text: str, said: str, line: int) -> None:
    assert first_message(text) == (said, f"at line {line} in {LINK}")


def test_every_number_of_a_link_has_its_own_field() -> None:
    robot = parse_robot(
        '<robot name="r"><link name="a">'
        f'<inertial><origin xyz="7 8 9"/><mass value="0.5"/><inertia {INERTIA}/></inertial>'
        '<visual name="v"><origin xyz="1 2 3"/><geometry><box size="4 5 6"/></geometry></visual>'
        '<visual><geometry><cylinder radius="1" length="2"/></geometry></visual>'
        '<collision name="c"><geometry><sphere radius="3"/></geometry></collision>'
        '<collision><geometry><mesh filename="m.stl" scale="1 2 3"/></geometry></collision>'
        '<collision><geometry><mesh filename="m.stl"/></geometry></collision></link></robot>'
    )
    link = robot.link("a")
    assert link.inertial == Inertial(0.5, (1.0, 2.0, 3.0, 4.0, 5.0, 6.0), Pose((7.0, 8.0, 9.0)))
    assert [each.geometry for each in link.visuals] == [Box((4.0, 5.0, 6.0)), Cylinder(1.0, 2.0)]
    assert (link.visuals[0].name, link.visuals[0].origin) == ("v", Pose((1.0, 2.0, 3.0)))
    assert [each.geometry for each in link.collisions] == [
        Sphere(3.0), Mesh("m.stl", (1.0, 2.0, 3.0)), Mesh("m.stl", (1.0, 1.0, 1.0)),
    ]  # fmt: skip
    assert link.collisions[0].name == "c"


def test_of_two_shapes_the_first_counts() -> None:
    two = '<geometry><sphere radius="3"/><box size="4 5 6"/></geometry>'
    link = parse_robot(f'<robot name="r"><link name="a"><collision>{two}</collision></link></robot>').link("a")
    assert [each.geometry for each in link.collisions] == [Sphere(3.0)]
    assert Inertial() == Inertial(0.0, (0.0, 0.0, 0.0, 0.0, 0.0, 0.0), Pose())


@pytest.mark.parametrize(
    ("rgba", "color"),
    [
        ("0.1 0.2 0.3 0.4", (0.1, 0.2, 0.3, 0.4)),
        ("0 0 0 0", (0.0, 0.0, 0.0, 0.0)),
        ("1 1 1 1", (1.0, 1.0, 1.0, 1.0)),
        ("1 1 1", (0.0, 0.0, 0.0, 1.0)),
        ("1 0 0 1.01", None),
        ("-0.01 0 0 1", None),
    ],
)
def test_a_colour_has_four_parts_from_0_to_1(rgba: str, color: tuple[float, ...] | None) -> None:
    report = check_text(
        f'<robot name="r"><material name="m"><color rgba="{rgba}"/><texture filename="t.png"/></material>'
        '<link name="a"/></robot>'
    )
    assert report.robot is not None
    assert report.robot.materials[0].color == color and report.robot.materials[0].texture == "t.png"
    assert bool(report.text) == (color is None)


@pytest.mark.parametrize(
    ("text", "value"),
    [("1", 1.0), ("+1.5e1", 15.0), (" .5", 0.5), ("-5.", -5.0), ("\t2E-1", 0.2), ("1e308", 1e308), ("007", 7.0)],
)
def test_numbers_are_read_as_by_a_cpp_stream(text: str, value: float) -> None:
    limit = joint_of(f'<limit lower="{text}" effort="1" velocity="1"/>').limit
    assert limit is not None and limit.lower == value


@pytest.mark.parametrize("text", ["", "nan", "inf", "0x10", "1 ", "1,5", "1e", "e5", ".", "+", "1e999", "٣", "--1"])
def test_what_a_cpp_stream_does_not_take_whole_is_no_number(text: str) -> None:
    assert first_message(joint_text(f'<limit lower="{text}" effort="1" velocity="1"/>')) == (
        f"lower value ({text}) is not a valid float",
        f"at line 112 in {JOINT}",
    )


# -- the robot ---------------------------------------------------------------------------------------------------------


@pytest.mark.parametrize(
    ("version", "said"),
    [
        ("1.0", ""),
        ("1.0.", ""),
        (" 1.+0", ""),
        ("01.00", ""),
        ("1", "The version attribute should be in the form 'x.y'"),
        ("1.0.0", "The version attribute should be in the form 'x.y'"),
        ("", "The version attribute should be in the form 'x.y'"),
        (".0", "One of the fields of the version attribute is blank"),
        ("a.0", "Version attribute is not an integer"),
        ("1.0a", "Extra characters after the version number"),
        ("1.-1", "Version number must be positive"),
        ("1.1", "Invalid 'version' specified; only version 1.0 is currently supported"),
        ("0.1", "Invalid 'version' specified; only version 1.0 is currently supported"),
    ],
)
def test_the_version_is_1_0_or_none(version: str, said: str) -> None:
    report = check_text(f'<robot name="r" version="{version}"><link name="a"/></robot>')
    assert report.text == (f"Error:   {said}\n         at line 135 in {MODEL}\n" if said else "")


@pytest.mark.parametrize(
    ("text", "said", "line"),
    [
        ('<robot name="r"/>', "No link elements found in urdf file", 207),
        (
            joint_text('</joint><joint name="j" type="fixed"><parent link="a"/><child link="b"/>'),
            "joint 'j' is not unique.",
            222,
        ),
        (
            joint_text("").replace('<parent link="a"/>', ""),
            "Failed to build tree: Joint [j] is missing a parent and/or child link specification.",
            253,
        ),
        (
            joint_text("").replace('<child link="b"/>', ""),
            "Failed to build tree: Joint [j] is missing a parent and/or child link specification.",
            253,
        ),
        (
            joint_text("").replace('parent link="a"', 'parent link="x"'),
            "Failed to build tree: parent link [x] of joint [j] not found.  This is not valid according to the URDF spec.",
            253,
        ),
    ],
)  # fmt: skip
def test_what_is_wrong_with_the_tree_is_said_with_its_line(text: str, said: str, line: int) -> None:
    message, place = first_message(text)
    assert message.startswith(said) and place == f"at line {line} in {MODEL}"


def tree(*pairs: str) -> Robot:
    """A robot whose joints go `from>to`, named in the order given."""
    links = sorted({name for pair in pairs for name in pair.split(">")})
    joints = (
        f'<joint name="{name}" type="fixed"><parent link="{pair.split(">")[0]}"/><child link="{pair.split(">")[1]}"/></joint>'
        for name, pair in zip("zyxwvu", pairs, strict=False)
    )
    return parse_robot(
        f'<robot name="r">{"".join(f"<link name={chr(34)}{n}{chr(34)}/>" for n in links)}{"".join(joints)}</robot>'
    )


def test_the_tree_is_walked_from_the_root_children_by_name_each_link_once() -> None:
    robot = tree("a>b", "a>c", "b>d", "c>d")
    assert (robot.root, [joint.name for joint in robot.children_of("a")]) == ("a", ["y", "z"])
    assert [(joint.name, joint.child) for joint in robot.tree()] == [("y", "c"), ("w", "d"), ("z", "b")]
    assert robot.loop == () and robot.children_of("d") == () and robot.has_joint("z") and not robot.has_joint("a")


def test_a_robot_is_shown_and_compared_by_what_the_file_says() -> None:
    robot = tree("a>b")
    assert "_links" not in repr(robot) and "_joints" not in repr(robot) and "_children" not in repr(robot)
    assert robot == tree("a>b") != tree("b>a")


def test_a_loop_is_found_and_named_round() -> None:
    assert tree("a>b", "b>c", "c>b").loop == ("b", "c", "b")
    assert tree("a>b", "b>b").loop == ("b", "b")
    assert tree("a>b", "a>c", "b>d", "c>d").loop == ()


def test_links_that_can_be_reached_in_many_ways_are_looked_at_once(monkeypatch: pytest.MonkeyPatch) -> None:
    looked: list[str] = []
    original = Robot.children_of
    monkeypatch.setattr(Robot, "children_of", lambda robot, link: looked.append(link) or original(robot, link))
    assert tree("a>b", "a>c", "b>d", "c>d", "d>e").loop == ()
    assert sorted(looked) == ["a", "b", "c", "d", "e"]


# -- yourdfpy's robot --------------------------------------------------------------------------------------------------


def rough(pose: Pose) -> list[float]:
    rotation = max(pose.rotation, tuple(-number for number in pose.rotation))
    return [*pose.xyz, *rotation]


@pytest.mark.parametrize("seed", range(4))
def test_what_yourdfpy_read_becomes_the_same_robot(seed: int, random_description: Callable[..., str]) -> None:
    """Without the way out that `load_robot` has when yourdfpy fails."""
    text = random_description(random.Random(seed), links=12)
    ours, theirs = parse_robot(text), yourdfpy_robot.robot_of(yourdfpy_robot.load(text))
    assert [joint.name for joint in ours.joints] == [joint.name for joint in theirs.joints]
    for one, other in zip(ours.joints, theirs.joints, strict=True):
        assert (one.type, one.parent, one.child, one.axis) == (other.type, other.parent, other.child, other.axis)
        assert (one.limit, one.mimic, one.dynamics) == (other.limit, other.mimic, other.dynamics)
        assert rough(one.origin) == pytest.approx(rough(other.origin), abs=1e-8)
    for link, same in zip(ours.links, theirs.links, strict=True):
        assert (link.inertial is None) == (same.inertial is None)
        if link.inertial and same.inertial:
            assert (link.inertial.mass, link.inertial.inertia) == (same.inertial.mass, same.inertial.inertia)
        for mine, yours in zip([*link.visuals, *link.collisions], [*same.visuals, *same.collisions], strict=True):
            assert (mine.geometry, mine.name) == (yours.geometry, yours.name)
            assert rough(mine.origin) == pytest.approx(rough(yours.origin), abs=1e-8)
        assert [v.material for v in link.visuals] == [v.material for v in same.visuals]
    assert ours.materials == theirs.materials


def test_what_yourdfpy_reads_apart_from_the_others_has_its_field() -> None:
    text = joint_text(
        '<limit lower="7" upper="8" effort="9" velocity="10"/>'
        '<safety_controller soft_lower_limit="11" soft_upper_limit="12" k_position="13" k_velocity="14"/>'
        '<calibration rising="15" falling="16"/><mimic joint="m" multiplier="17" offset="18"/>'
        '<dynamics damping="19" friction="20"/>'
    ).replace('name="a"/>', 'name="a"><visual><geometry><mesh filename="m" scale="2"/></geometry></visual></link>', 1)
    robot = yourdfpy_robot.robot_of(yourdfpy_robot.load(text))
    joint = robot.joint("j")
    assert joint.safety == Safety(11.0, 12.0, 13.0, 14.0) and joint.limit == Limit(7.0, 8.0, 9.0, 10.0)
    assert joint.calibration == Calibration(15.0, 16.0) and joint.mimic == Mimic("m", 17.0, 18.0)
    assert joint.dynamics == Dynamics(19.0, 20.0)
    assert robot.link("a").visuals[0].geometry == Mesh("m", (2.0, 2.0, 2.0))
    assert (
        yourdfpy_robot.robot_of(yourdfpy_robot.load(joint_text("<calibration/>"))).joint("j").calibration
        == Calibration()
    )


# -- rotations ---------------------------------------------------------------------------------------------------------

AXES = ((1.0, 0.0, 0.0), (0.0, 1.0, 0.0), (0.0, 0.0, 1.0))


@pytest.mark.parametrize(("first", "second"), list(itertools.permutations(range(3), 2)))
def test_a_quarter_turn_takes_one_axis_to_the_next(first: int, second: int) -> None:
    third = 3 - first - second
    sign = 1 if (first, second) in ((0, 1), (1, 2), (2, 0)) else -1
    turn = about(tuple(sign * number for number in AXES[third]), math.pi / 2)  # type: ignore[arg-type]
    assert rotate(turn, AXES[first]) == pytest.approx(AXES[second], abs=1e-12)
    assert [row[first] for row in matrix(Pose((5.0, 6.0, 7.0), turn))] == pytest.approx([*AXES[second], 0.0], abs=1e-12)
    assert [row[3] for row in matrix(Pose((5.0, 6.0, 7.0), turn))] == [5.0, 6.0, 7.0, 1.0]
    assert abs(multiply(turn, turn)[third]) == pytest.approx(1.0)


@pytest.mark.parametrize("seed", range(20))
def test_rotating_multiplying_and_the_matrix_agree(seed: int) -> None:
    choice = random.Random(seed)

    def pose() -> Pose:
        numbers = [choice.uniform(-3, 3) for _ in range(6)]
        return Pose.from_rpy((numbers[0], numbers[1], numbers[2]), (numbers[3], numbers[4], numbers[5]))

    one, other = pose(), pose()
    rows = [[sum(a * b for a, b in zip(row, column, strict=True)) for column in zip(*matrix(other), strict=True)]
            for row in matrix(one)]  # fmt: skip
    for row, expected in zip(matrix(compose(one, other)), rows, strict=True):
        assert row == pytest.approx(expected, abs=1e-9)
    assert math.hypot(*one.rotation) == pytest.approx(1.0)


@pytest.mark.parametrize(
    "rpy", [(0.3, -0.4, 0.5), (-2.0, 1.2, 3.0), (0.0, 0.0, -3.0), (3.0, -1.5, 0.1), (0.1, 1.56, -0.2)]
)
def test_roll_pitch_and_yaw_come_back(rpy: tuple[float, float, float]) -> None:
    assert Pose.from_rpy((0.0, 0.0, 0.0), rpy).rpy == pytest.approx(rpy, abs=1e-6)


@pytest.mark.parametrize(("pitch", "sign"), [(math.pi / 2, 1), (-math.pi / 2, -1)])
def test_straight_up_and_down_have_no_roll(pitch: float, sign: int) -> None:
    roll, straight, yaw = Pose.from_rpy((0.0, 0.0, 0.0), (0.0, pitch, 0.7)).rpy
    assert (roll, straight) == (0.0, sign * math.pi / 2) and yaw == pytest.approx(0.7, abs=1e-3)


@pytest.mark.parametrize(
    ("rotation", "sign"),
    [
        ((0.0, 0.0, 0.6, 0.8), 1), ((0.0, 0.0, 0.6, -0.8), -1), ((-0.9, 0.3, 0.3, 0.1), -1), ((0.9, -0.3, -0.3, -0.1), 1),
        ((0.3, -0.9, 0.3, 0.1), -1), ((-0.3, 0.9, -0.3, -0.1), 1), ((0.3, 0.3, -0.9, 0.1), -1), ((-0.3, -0.3, 0.9, 0.1), 1),
    ],
)  # fmt: skip
def test_the_sign_of_a_quaternion_is_that_of_w_or_of_the_largest(rotation: tuple[float, ...], sign: int) -> None:
    assert canonical(rotation) == tuple(sign * number for number in rotation)  # type: ignore[arg-type]


def test_a_joint_moves_from_its_origin_along_or_about_its_axis() -> None:
    origin = '<origin xyz="1 2 3" rpy="0 0 1.5707963267948966"/>'
    limit = '<limit upper="1" effort="1" velocity="1"/>'
    slide = joint_transform(joint_of(f'{origin}<axis xyz="3 0 4"/>{limit}', "prismatic"), 0.5)
    assert slide.xyz == pytest.approx((1.0, 2.3, 3.4))
    assert joint_transform(joint_of(f'{origin}<axis xyz="0 0 0"/>{limit}', "prismatic"), 0.5).xyz == (1.0, 2.0, 3.0)
    for kind in ("revolute", "continuous"):
        turned = joint_transform(joint_of(f'{origin}<axis xyz="0 0 2"/>{limit}', kind), 0.5)
        assert turned.rpy == pytest.approx((0.0, 0.0, math.pi / 2 + 0.5)) and turned.xyz == (1.0, 2.0, 3.0)
    for kind in ("fixed", "floating", "planar"):
        assert joint_transform(joint_of(origin, kind), 0.5).rpy == pytest.approx((0.0, 0.0, math.pi / 2))
    assert about((0.0, 0.0, 0.0), 1.0) == (0.0, 0.0, 0.0, 1.0)


# -- advice ------------------------------------------------------------------------------------------------------------


def rolling(shape: str, axis: str, kind: str = "continuous", more: str = "", rpy: str = "1.5707963 0 0") -> str:
    return (
        f'<robot name="r"><link name="a"/><link name="w"><visual><origin xyz="0 0 {more or 0}" rpy="{rpy}"/>'
        f'<geometry>{shape}</geometry></visual></link>\n <joint name="j" type="{kind}"><parent link="a"/><child link="w"/>'
        f'<axis xyz="{axis}"/><limit lower="1" upper="1" effort="1" velocity="1"/></joint></robot>'
    )


DISC = '<cylinder radius="0.1" length="0.2"/>'


@pytest.mark.parametrize(
    ("text", "advice"),
    [
        (rolling(DISC, "0 1 0"), None),
        (rolling(DISC, "0 1 0.5"), None),
        (rolling(DISC, "1 0 0"), "wheel w does not turn"),
        (rolling(DISC, "2 0.9 0"), "wheel w does not turn"),
        (rolling(DISC, "0 0 0"), "joint j has no axis"),
        (rolling(DISC, "0 1 0", "revolute"), "joint j can only move from 1 to 1"),
        (rolling(DISC, "1 0 0", "prismatic"), None),
        (rolling('<cylinder radius="0.1" length="0.21"/>', "1 0 0"), None),
        (rolling(DISC, "1 0 0", more="0.05"), "wheel w does not turn"),
        (rolling(DISC, "1 0 0", more="0.06"), None),
        (rolling('<box size="1 1 1"/>', "1 0 0"), None),
    ],
)
def test_advice_is_given_for_what_is_accepted_and_will_not_work(text: str, advice: str | None) -> None:
    hint = advice_of(parse_robot(text), text)
    if advice is None:
        assert hint is None
    else:
        assert hint is not None and advice in hint.text and (hint.line, hint.column) == (2, 2)


# -- XML ---------------------------------------------------------------------------------------------------------------


def value(text: str) -> str:
    (element,) = read_xml(f'<a b="{text}"/>')
    return element.attributes["b"]


@pytest.mark.parametrize(
    ("raw", "plain"),
    [
        ("&lt;&gt;&amp;&quot;&apos;", "<>&\"'"), ("&#65;&#x41;&#x6a;", "AAj"), ("&#20013;", "中"), ("&nbsp;&", "&nbsp;&"),
        ("&#0;", "&#0;"), ("&#1;", "\x01"), ("&#x10FFFF;", "\U0010ffff"), ("&#x110000;", "&#x110000;"),
        ("&#xD7FF;", "\ud7ff"), ("&#xD800;", "&#xD800;"), ("&#xDFFF;", "&#xDFFF;"), ("&#xE000;", "\ue000"),
        ("&#00000065;", "A"), ("&#000000065;", "&#000000065;"), ("a\r\nb\rc\n\rd", "a\nb\nc\nd"), ("'", "'"),
    ],
)  # fmt: skip
def test_entities_and_line_ends_in_a_value(raw: str, plain: str) -> None:
    assert value(raw) == plain


@pytest.mark.parametrize(
    ("text", "said"),
    [
        ("", "Error=XML_ERROR_EMPTY_DOCUMENT ErrorID=13 (0xd) Line number=0"),
        ("\n\nx", "Error=XML_ERROR_PARSING_TEXT ErrorID=8 (0x8) Line number=3"),
        ("<a>\n<b>", "Error=XML_ERROR_PARSING ErrorID=15 (0xf) Line number=2"),
        ("\n<!-- x", "Error=XML_ERROR_PARSING_COMMENT ErrorID=10 (0xa) Line number=2"),
        ("<![CDATA[ x", "Error=XML_ERROR_PARSING_CDATA ErrorID=9 (0x9) Line number=1"),
        ("<!x", "Error=XML_ERROR_PARSING_UNKNOWN ErrorID=12 (0xc) Line number=1"),
        ("<?x", "Error=XML_ERROR_PARSING_DECLARATION ErrorID=11 (0xb) Line number=1"),
        ("<a/><?x?>", "Error=XML_ERROR_PARSING_DECLARATION ErrorID=11 (0xb) Line number=1: XMLDeclaration value=x"),
        ("<a\n", "Error=XML_ERROR_PARSING_ELEMENT ErrorID=6 (0x6) Line number=1: XMLElement name=a"),
        ("<a ?>", "Error=XML_ERROR_PARSING_ELEMENT ErrorID=6 (0x6) Line number=1"),
        ("<a\n b>", "Error=XML_ERROR_PARSING_ATTRIBUTE ErrorID=7 (0x7) Line number=2: XMLElement name=a"),
        ("<a b=c/>", "Error=XML_ERROR_PARSING_ATTRIBUTE ErrorID=7 (0x7) Line number=1: XMLElement name=a"),
        ("<a b='c/>", "Error=XML_ERROR_PARSING_ATTRIBUTE ErrorID=7 (0x7) Line number=1: XMLElement name=a"),
        ("<a b='1' b='2'/>", "Error=XML_ERROR_PARSING_ATTRIBUTE ErrorID=7 (0x7) Line number=1: XMLElement name=a"),
        ("<a>\n<b></a>", "Error=XML_ERROR_MISMATCHED_ELEMENT ErrorID=14 (0xe) Line number=2: XMLElement name=b"),
        ("<1/>", "Error=XML_ERROR_PARSING ErrorID=15 (0xf) Line number=1"),
    ],
)
def test_broken_xml_is_told_with_tinyxmls_words_number_and_line(text: str, said: str) -> None:
    with pytest.raises(XmlError) as raised:
        read_xml(text)
    assert str(raised.value) == said


def nested(depth: int) -> str:
    return "<a>" * depth + "</a>" * depth


def test_elements_may_be_498_deep() -> None:
    assert read_xml(nested(498))
    with pytest.raises(XmlError, match=r"XML_ELEMENT_DEPTH_EXCEEDED ErrorID=18 .*: Element nesting is too deep\."):
        read_xml(nested(499))


def shown(elements: list[Element]) -> list[object]:
    return [(element.tag, element.attributes, shown(element.children)) for element in elements]


@pytest.mark.parametrize(
    ("text", "elements"),
    [
        ("<?xml?><?y?><a/>", [("a", {}, [])]),
        ("\ufeff <a/>", [("a", {}, [])]),
        ("<a/> text <b/>", [("a", {}, []), ("b", {}, [])]),
        ("<a>x<!-- <c/> --><b c = 'd'/><![CDATA[<e/>]]></a>", [("a", {}, [("b", {"c": "d"}, [])])]),
        ("<a/></a><b/>", [("a", {}, [])]),
        ("<a/>\0<b", [("a", {}, [])]),
        ("<!DOCTYPE a><a></a >", [("a", {}, [])]),
        ("< a/>", [("a", {}, [])]),
        ("<a><b/></a><c x='1' y='2'><d/><e/></c>", None),
    ],
)
def test_what_tinyxml_lets_pass_is_read(text: str, elements: list[object] | None) -> None:
    found = read_xml(text)
    if elements is not None:
        assert shown(found) == elements
    assert shown(read_xml(write_xml(found))) == shown(found)


def test_written_xml_keeps_every_character_of_a_value() -> None:
    text = write_xml([Element("a", {"b": "<&\"\n\t'>"}, 0)])
    assert text == '<a b="&lt;&amp;&quot;&#10;&#9;\'>"/>'
    assert read_xml(text)[0].attributes == {"b": "<&\"\n\t'>"}


def test_what_is_said_of_no_element_has_no_place() -> None:
    (said,) = check_text("<rbot/>").diagnostics
    assert (said.line, said.column) == (0, 0)
    (said,) = check_text("\n <robot/>").diagnostics
    assert (said.line, said.column) == (2, 2)
