"""joint_state_publisher 2.4: what it publishes for which robot and parameters, and what it complains of."""

from __future__ import annotations

import math
from pathlib import Path
from typing import TYPE_CHECKING, Any

import pytest
from sensor_msgs.msg import JointState
from std_msgs.msg import String

import rclpy
from day6_core.ros.environment import activate
from day6_urdf import shipped_model
from rclpy.qos import DurabilityPolicy, QoSProfile

if TYPE_CHECKING:
    from tests.support.stepped_machine import SteppedMachine

LATCHED = QoSProfile(depth=1, durability=DurabilityPolicy.TRANSIENT_LOCAL)
WAITING = (
    "[INFO] [joint_state_publisher]: Waiting for robot_description to be published on the robot_description topic..."
)


def start(machine: SteppedMachine, *args: str) -> Any:
    return machine.start("joint_state_publisher", "joint_state_publisher", *args)


def positions(state: JointState) -> dict[str, float]:
    return dict(zip(state.name, state.position, strict=True))


def test_ten_times_a_second_every_movable_joint_at_its_zero(machine: SteppedMachine, arm: str) -> None:
    seen = machine.watch(JointState, "/joint_states")
    start(machine, arm)
    machine.advance(1.0)
    assert len(seen) == 10
    state = seen[-1]
    assert list(state.name) == ["turn", "bend", "far", "slide", "soft", "stiff", "follows", "follows_it"]
    # 0 is outside of the limits of two joints: then the middle is zero.
    assert positions(state) == pytest.approx(
        {"turn": 0, "bend": 0, "far": 1.5, "slide": 0, "soft": 0, "stiff": 0.3, "follows": 0.1, "follows_it": 0.9}
    )
    assert len(state.velocity) == len(state.effort) == 0


def test_it_waits_for_a_description_and_takes_another_one_later(machine: SteppedMachine) -> None:
    seen = machine.watch(JointState, "/joint_states")
    running = start(machine)
    machine.advance(1.0)
    assert running.log == [WAITING] and seen == []
    publisher = machine.node.create_publisher(String, "/robot_description", LATCHED)
    publisher.publish(String(data=shipped_model().read_text(encoding="utf-8")))
    machine.advance(0.3)
    assert positions(seen[-1]) == {"left_wheel_joint": 0.0, "right_wheel_joint": 0.0}
    text = '<robot name="r"><link name="a"/><link name="b"/><joint name="other" type="continuous"/></robot>'
    publisher.publish(String(data=text))
    machine.advance(0.3)
    assert positions(seen[-1]) == {"other": 0.0}


def test_zeros_rate_velocities_and_efforts_are_parameters(machine: SteppedMachine, arm: str) -> None:
    seen = machine.watch(JointState, "/joint_states")
    given = ("zeros.bend:=0.7", "rate:=50", "publish_default_velocities:=true", "publish_default_efforts:=true")
    start(machine, arm, "--ros-args", *[word for item in given for word in ("-p", item)])
    machine.advance(1.0)
    assert len(seen) == 50
    assert positions(seen[-1])["bend"] == 0.7 and positions(seen[-1])["follows"] == pytest.approx(1.5)
    assert list(seen[-1].velocity) == list(seen[-1].effort) == [0.0] * 8


def test_mimic_tags_and_soft_limits_can_be_left_aside(machine: SteppedMachine, arm: str) -> None:
    seen = machine.watch(JointState, "/joint_states")
    given = ("use_mimic_tags:=false", "use_smallest_joint_limits:=false", "delta:=0.3")
    start(machine, arm, "--ros-args", *[word for item in given for word in ("-p", item)])
    machine.advance(0.7)
    last = positions(seen[-1])
    assert last["follows"] == pytest.approx(2.1)  # free, as continuous as it is
    assert last["soft"] == 2.0


def test_delta_moves_joints_to_and_fro_between_their_limits(machine: SteppedMachine, arm: str) -> None:
    seen = machine.watch(JointState, "/joint_states")
    start(machine, arm, "--ros-args", "-p", "delta:=0.4")
    machine.advance(1.0)
    assert [round(positions(state)["soft"], 6) for state in seen[:6]] == [0.4, 0.8, 1.0, 0.6, 0.2, -0.2]
    assert [round(positions(state)["turn"], 6) for state in seen[6:9]] == [
        2.8,
        round(-math.pi, 6),
        round(0.4 - math.pi, 6),
    ]


def test_joints_can_be_made_to_follow_by_parameters(machine: SteppedMachine) -> None:
    seen = machine.watch(JointState, "/joint_states")
    given = (
        "zeros.left_wheel_joint:=0.5",
        "dependent_joints.right_wheel_joint.parent:=left_wheel_joint",
        "dependent_joints.right_wheel_joint.factor:=-2.0",
        "dependent_joints.right_wheel_joint.offset:=0.1",
    )
    start(machine, str(shipped_model()), "--ros-args", *[word for item in given for word in ("-p", item)])
    machine.advance(0.2)
    assert positions(seen[-1]) == pytest.approx({"left_wheel_joint": 0.5, "right_wheel_joint": -0.9})


def test_other_topics_can_be_its_sources(machine: SteppedMachine) -> None:
    seen = machine.watch(JointState, "/joint_states")
    start(machine, str(shipped_model()), "--ros-args", "-p", "source_list:=[wheels]")
    source = machine.node.create_publisher(JointState, "/wheels", 10)
    machine.advance(0.1)
    source.publish(JointState(name=["left_wheel_joint", "nobody"], position=[1.25, 3.0], velocity=[0.5, 0.0]))
    machine.advance(0.2)
    assert positions(seen[-1]) == {"left_wheel_joint": 1.25, "right_wheel_joint": 0.0}
    assert list(seen[-1].velocity) == [0.5, 0.0]


JOINT = '<robot name="r"><link name="a"/><link name="b"/><joint name="j" type="revolute">{}</joint></robot>'

SDF = '<sdf version="1.8"><model name="m"><joint name="j" type="revolute"><axis>{}</axis></joint></model></sdf>'
COLLADA = (
    '<COLLADA xmlns="http://www.collada.org/2008/03/COLLADASchema" version="1.5.0"><kinematics_model><technique_common>'
    '<joint name="j"><revolute>{}</revolute></joint></technique_common></kinematics_model></COLLADA>'
)


@pytest.mark.parametrize(
    ("text", "expected"),
    [
        ("<urdf>" + JOINT.format('<limit lower="1" upper="3"/>') + "</urdf>", {"j": 2.0}),
        (SDF.format("<limit><lower>1</lower><upper>3</upper></limit>"), {"j": 2.0}),
        (SDF.format("").replace("revolute", "continuous"), {"j": 0.0}),
        (SDF.format("").replace("revolute", "ball"), {}),
        (COLLADA.format("<limits><min>-90</min><max>90</max></limits>"), {"j": 0.0}),
        (COLLADA.format("<limits><min>0</min><max>0</max></limits>"), {}),
    ],
)
def test_joints_of_a_wrapped_robot_of_sdf_and_of_collada(
    machine: SteppedMachine, text: str, expected: dict[str, float]
) -> None:
    seen = machine.watch(JointState, "/joint_states")
    running = start(machine)
    machine.advance(0.1)
    machine.node.create_publisher(String, "/robot_description", LATCHED).publish(String(data=text))
    machine.advance(0.3)
    assert running.log == [WAITING]
    assert [positions(state) for state in seen[-1:]] == ([expected] if expected else [])


@pytest.mark.parametrize(
    ("text", "said"),
    [
        (JOINT.format(""), 'Limits must be specified for joint "j" of type "revolute"'),
        (JOINT.format('<limit upper="1"/>'), '"lower" limit must be specified for joint "j" of type "revolute"'),
        (
            JOINT.format('<limit lower="x" upper="1"/>'),
            '"lower" limit must be a float for joint "j" of type "revolute"',
        ),
        ('<robot name="r">\n<link></robot>', "mismatched tag: line 2, column 8"),
        ("<urdf/>", 'URDF must have a "robot" tag'),
        ("<sdf/>", 'SDF must have a "model" tag'),
        (SDF.format(""), 'Limits must be specified for joint "j" of type "revolute"'),
        (
            SDF.format("<limit><upper>1</upper></limit>"),
            '"lower" limit must be specified for joint "j" of type "revolute"',
        ),
        (
            SDF.format("<limit><lower>0</lower><upper>x</upper></limit>"),
            '"upper" limit must be a float for joint "j" of type "revolute"',
        ),
        ("<COLLADA/>", "COLLADA must have a version tag"),
        ('<COLLADA version="1.4.1"/>', "COLLADA must be at least version 1.5.0"),
        ('<COLLADA version="1.5.0"/>', 'COLLADA must have a "kinematics_model" tag'),
        (
            '<COLLADA version="1.5.0"><kinematics_model/></COLLADA>',
            'COLLADA must have a "technique_common" tag',
        ),
        (
            COLLADA.format("<limits><max>1</max></limits>"),
            '"min" limit must be specified for joint "j" of type "revolute"',
        ),
        ("", "no element found: line 1, column 0"),
        (
            '<!DOCTYPE r [<!ENTITY a "ha"><!ENTITY b "&a;&a;&a;&a;">]><robot name="&b;"/>',
            "entity definitions are not allowed in a robot description",
        ),
        (
            '<!DOCTYPE r [<!ENTITY a SYSTEM "file:///etc/passwd">]><robot name="r">&a;</robot>',
            "entity definitions are not allowed in a robot description",
        ),
    ],
)
def test_a_description_it_cannot_use_is_warned_of_and_the_last_one_stays(
    machine: SteppedMachine, text: str, said: str
) -> None:
    seen = machine.watch(JointState, "/joint_states")
    running = start(machine, str(shipped_model()))
    publisher = machine.node.create_publisher(String, "/robot_description", LATCHED)
    publisher.publish(String(data=text))
    machine.advance(0.5)
    assert running.log == [f"[WARN] [joint_state_publisher]: {said}"]
    assert list(seen[-1].name) == ["left_wheel_joint", "right_wheel_joint"]


def test_on_the_command_line_such_a_file_ends_it(machine: SteppedMachine, tmp_path: Path) -> None:
    file = tmp_path / "bad.urdf"
    file.write_text(JOINT.format(""), encoding="utf-8")
    running = start(machine, str(file))
    assert running.program.status == 1
    assert running.errors == 'Exception: Limits must be specified for joint "j" of type "revolute"\n'
    missing = start(machine, "nowhere.urdf")
    assert missing.program.status == 1
    assert missing.errors == "FileNotFoundError: [Errno 2] No such file or directory: 'nowhere.urdf'\n"


def test_joints_that_follow_each_other_in_a_ring_end_it(machine: SteppedMachine, tmp_path: Path) -> None:
    ring = "".join(
        f'<link name="{a}l"/><joint name="{a}" type="continuous"><mimic joint="{b}"/></joint>' for a, b in ("xy", "yx")
    )
    file = tmp_path / "ring.urdf"
    file.write_text(f'<robot name="r">{ring}</robot>', encoding="utf-8")
    running = start(machine, str(file))
    machine.advance(0.2)
    assert running.program.status == 1
    assert running.log == ["[ERROR] [joint_state_publisher]: Found an infinite recursive mimic chain: ['x', 'y', 'x']"]


@pytest.mark.parametrize(
    ("parameter", "said"),
    [
        ("dependent_joints.a:=b", "Invalid dependent_joint name 'a'"),
        (
            "dependent_joints.a.mother:=b",
            "Invalid dependent_joint name 'mother' (allowed values are 'parent', 'factor', 'offset')",
        ),
        ("dependent_joints.a.factor:=2.0", "All dependent_joints must at least have a parent"),
    ],
)
def test_wrong_dependent_joints_end_it(machine: SteppedMachine, parameter: str, said: str) -> None:
    running = start(machine, "--ros-args", "-p", parameter)
    assert (running.program.status, running.errors) == (1, f"Exception: {said}\n")


def test_it_explains_itself(machine: SteppedMachine) -> None:
    running = start(machine, "--help")
    assert running.program.status == 0
    assert running.output.startswith("usage: joint_state_publisher [-h] [description_file]\n")
    assert start(machine, "a", "b").program.status == 2


def test_a_program_that_imports_the_node_reads_and_moves_its_joints(arm: str) -> None:
    activate()
    from joint_state_publisher.joint_state_publisher import JointStatePublisher

    with rclpy.init(args=["--ros-args", "-p", "publish_default_velocities:=true"]):
        node = JointStatePublisher(arm)
        free = node.free_joints
        assert node.joint_list == ["turn", "bend", "far", "slide", "soft", "stiff", "follows", "follows_it"]
        assert list(free) == node.joint_list[:6]
        assert free["far"] == {"min": 1.0, "max": 2.0, "zero": 1.5, "position": 1.5, "velocity": 0.0}
        assert free["turn"]["continuous"] and "effort" not in free["turn"]
        assert node.dependent_joints["follows"] == {"parent": "bend", "factor": 2.0, "offset": 0.1}
        seen: list[JointState] = []
        node.create_subscription(JointState, "joint_states", seen.append, 10)
        free["far"]["position"] = 1.25
        with pytest.raises(KeyError):
            free["far"]["speed"] = 1.0
        while not seen:
            rclpy.spin_once(node)
        assert positions(seen[0])["far"] == 1.25
