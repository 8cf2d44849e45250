"""What is said about broken descriptions, in urdfdom 4.0.1's words and order."""

from __future__ import annotations

import json
import os
from pathlib import Path

import pytest

from day6_urdf import Report, check_file, check_text
from day6_urdf.check import MAX_BYTES

GOLDEN = Path(__file__).resolve().parents[1] / "conformance" / "golden" / "check_urdf.jsonl"
"""Recorded from the real tools."""

HEAD = '<robot name="r"><link name="a"/><link name="b"/>'
JOINT = '<joint name="j" type="{0}"><parent link="a"/><child link="b"/>{1}</joint></robot>'
MODEL, LINK, JOINTS, POSE = (f"./urdf_parser/src/{name}.cpp" for name in ("model", "link", "joint", "pose"))
JOINT_FAILED = ("joint xml is not initialized correctly", 234, MODEL)

REFUSED = {
    "no robot element": ("<rbot/>", [("Could not find the 'robot' element in the xml file", 110, MODEL)]),
    "robot without a name": ('<robot><link name="a"/></robot>', [("No name given for the robot.", 119, MODEL)]),
    "version 2.0": (
        '<robot name="r" version="2.0"><link name="a"/></robot>',
        [("Invalid 'version' specified; only version 1.0 is currently supported", 135, MODEL)],
    ),
    "version 1": (
        '<robot name="r" version="1"><link name="a"/></robot>',
        [("The version attribute should be in the form 'x.y'", 135, MODEL)],
    ),
    "two materials of one name": (
        (
            '<robot name="r"><material name="m"><color rgba="1 0 0 1"/></material>'
            '<material name="m"><color rgba="0 0 1 1"/></material><link name="a"/></robot>'
        ),
        [("material 'm' is not unique.", 150, MODEL)],
    ),
    "unknown child": (
        '<robot name="r"><link name="a"/><joint name="j" type="fixed"><parent link="a"/><child link="x"/></joint></robot>',
        [("Failed to build tree: child link [x] of joint [j] not found", 253, MODEL)],
    ),
    "two links of one name": (
        '<robot name="r"><link name="a"/><link name="a"/></robot>',
        [("link 'a' is not unique.", 179, MODEL)],
    ),
    "two roots": (
        HEAD + "</robot>",
        [("Failed to find root link: Two root links found: [a] and [b]", 265, MODEL)],
    ),
    "a loop of everything": (
        HEAD
        + '<joint name="j" type="fixed"><parent link="a"/><child link="b"/></joint>'
        + '<joint name="k" type="fixed"><parent link="b"/><child link="a"/></joint></robot>',
        [("Failed to find root link: No root link found. The robot xml is not a valid tree.", 265, MODEL)],
    ),
    "revolute without limits": (
        HEAD + JOINT.format("revolute", ""),
        [("Joint [j] is of type REVOLUTE but it does not specify limits", 461, JOINTS), JOINT_FAILED],
    ),
    "unknown joint type": (
        HEAD + JOINT.format("hinge", ""),
        [("Joint [j] has no known type [hinge]", 420, JOINTS), JOINT_FAILED],
    ),
    "limit with letters": (
        HEAD + JOINT.format("revolute", '<limit lower="low" effort="1" velocity="1"/>'),
        [
            ("lower value (low) is not a valid float", 112, JOINTS),
            ("Could not parse limit element for joint [j]", 454, JOINTS),
            JOINT_FAILED,
        ],
    ),
    "mimic of nobody": (
        HEAD + JOINT.format("continuous", "<mimic/>"),
        [
            ("joint mimic: no mimic joint specified", 292, JOINTS),
            ("Could not parse mimic element for joint  [j]", 503, JOINTS),
            JOINT_FAILED,
        ],
    ),
    "dynamics without anything": (
        HEAD + JOINT.format("fixed", "<dynamics/>"),
        [
            ("joint dynamics element specified with no damping and no friction", 88, JOINTS),
            ("Could not parse joint_dynamics element for joint [j]", 516, JOINTS),
            JOINT_FAILED,
        ],
    ),
    "origin of two numbers": (
        HEAD + JOINT.format("fixed", '<origin xyz="1 2"/>'),
        [
            ("Parser found 2 elements but 3 expected while parsing vector [1 2]", 104, POSE),
            ("Malformed parent origin element for joint [j]", 362, JOINTS),
            JOINT_FAILED,
        ],
    ),
    "NaN in an axis": (
        HEAD + JOINT.format("continuous", '<axis xyz="0 nan 0"/>'),
        [
            (
                (
                    "Malformed axis element for joint [j]:"
                    " Unable to parse component [nan] to a double (while parsing a vector value)"
                ),
                440,
                JOINTS,
            ),
            JOINT_FAILED,
        ],
    ),
    "nothing but blanks": (
        " \n ",
        [("Error=XML_ERROR_EMPTY_DOCUMENT ErrorID=13 (0xd) Line number=0", 101, MODEL)],
    ),
}

ACCEPTED = {
    "NaN size": (
        '<visual><geometry><box size="1 nan 1"/></geometry></visual>',
        [
            ("Unable to parse component [nan] to a double (while parsing a vector value)", 150, LINK),
            ("Could not parse visual element for Link [a]", 453, LINK),
        ],
    ),
    "cylinder without a length": (
        '<visual><geometry><cylinder radius="1"/></geometry></visual>',
        [
            ("Cylinder shape must have both length and radius attributes", 164, LINK),
            ("Could not parse visual element for Link [a]", 453, LINK),
        ],
    ),
    "empty geometry": (
        "<visual><geometry/></visual>",
        [
            ("Geometry tag contains no child element.", 227, LINK),
            ("Could not parse visual element for Link [a]", 453, LINK),
        ],
    ),
    "no geometry": ("<visual/>", [("Could not parse visual element for Link [a]", 453, LINK)]),
    "mesh with a bad scale": (
        '<visual><geometry><mesh filename="x.stl" scale="2"/></geometry></visual>',
        [
            (
                (
                    "Mesh scale was specified, but could not be parsed:"
                    " Parser found 1 elements but 3 expected while parsing vector [2]"
                ),
                208,
                LINK,
            ),
            ("Could not parse visual element for Link [a]", 453, LINK),
        ],
    ),
    "collision with letters": (
        '<collision><geometry><sphere radius="r"/></geometry></collision>',
        [
            ("radius [r] is not a valid float", 126, LINK),
            ("Could not parse collision element for Link [a]", 475, LINK),
        ],
    ),
    "inertia with a gap": (
        '<inertial><mass value="1"/><inertia ixx="1" ixy="0"/></inertial>',
        [
            ("Inertial: inertia element missing ixz attribute", 325, LINK),
            ("Could not parse inertial element for Link [a]", 435, LINK),
        ],
    ),
}


def said(messages: list[tuple[str, int, str]]) -> str:
    return "".join(f"Error:   {text}\n         at line {line} in {file}\n" for text, line, file in messages)


@pytest.mark.parametrize("name", REFUSED)
def test_a_broken_description_is_refused_in_urdfdoms_words(name: str) -> None:
    text, messages = REFUSED[name]
    report = check_text(text)
    assert report.robot is None
    assert report.text == said(messages)


@pytest.mark.parametrize("name", ACCEPTED)
def test_a_broken_part_of_a_link_is_named_and_left_away(name: str) -> None:
    part, messages = ACCEPTED[name]
    report = check_text(f'<robot name="r"><link name="a">{part}</link></robot>')
    assert report.text == said(messages)
    assert report.robot is not None
    assert report.robot.link("a").visuals == report.robot.link("a").collisions == ()


def test_an_undefined_material_is_warned_of_twice_for_the_first_visual() -> None:
    shape = '<geometry><sphere radius="1"/></geometry>'
    visual = f'<visual>{shape}<material name="gold"/></visual>'
    warning = "Warning: link 'a' material 'gold' undefined.\n         at line 85 in ./urdf_parser/src/model.cpp\n"
    report = check_text(f'<robot name="r"><link name="a">{visual}{visual}</link></robot>')
    assert report.text == 3 * warning
    assert report.robot is not None
    assert report.robot.link("a").visuals[0].material is None


def test_a_message_knows_the_line_and_column_that_caused_it() -> None:
    report = check_text('<robot name="r">\n  <link name="a">\n    <visual/>\n  </link>\n  <link name="a"/>\n</robot>')
    assert [(said.line, said.column) for said in report.diagnostics] == [(2, 3), (5, 3)]


def test_a_file_that_is_missing_or_a_folder_is_an_empty_description(tmp_path: Path) -> None:
    empty = said([("Error=XML_ERROR_EMPTY_DOCUMENT ErrorID=13 (0xd) Line number=0", 101, MODEL)])
    assert check_file(tmp_path / "no_such.urdf").text == empty
    assert check_file(tmp_path).text == empty


def test_a_file_of_50_megabytes_is_not_read(tmp_path: Path) -> None:
    huge = tmp_path / "huge.urdf"
    with huge.open("wb") as file:
        file.write(b'<robot name="r"><link name="a"/>')
        os.truncate(file.fileno(), 50_000_000)
    report = check_file(huge)
    assert report.robot is None
    assert report.text == "Error:   The robot description is too large: 50.0 MB, more than 4 MB are not read\n"
    assert check_text(" " * (MAX_BYTES + 1)).robot is None


def test_a_device_without_an_end_is_not_read_for_ever() -> None:
    if not Path("/dev/zero").exists():
        pytest.skip("no /dev/zero here")
    assert "too large" in check_file("/dev/zero").text


def test_every_recorded_case_of_the_real_parser_is_equal() -> None:
    different = []
    for line in GOLDEN.read_text(encoding="utf-8").splitlines():
        case = json.loads(line)
        if case["urdf"] is not None and case["argv"][0] == "check_urdf":
            text = case["urdf"] if case["urdf"].endswith("\n") else case["urdf"] + "\n"  # check_urdf reads whole lines
            report = check_text(text)
            failure = "" if report.robot else "ERROR: Model Parsing the xml failed\n"
            if report.text + failure != case["stderr"] or _root_line(report) not in case["stdout"]:
                different.append(case["name"])
    assert different == []


def _root_line(report: Report) -> str:
    """Return check_urdf's line about the root link; a refused robot has none."""
    robot = report.robot
    if robot is None:
        return ""
    return f"root Link: {robot.root} has {len(robot.children_of(robot.root))} child(ren)"
