"""robot_state_publisher: what it publishes, when, and what it says when something is wrong."""

from __future__ import annotations

import math
from pathlib import Path
from typing import TYPE_CHECKING, Any

import pytest
from rcl_interfaces.msg import Parameter, ParameterType, ParameterValue
from rcl_interfaces.srv import ListParameters, SetParameters
from std_msgs.msg import String
from tf2_msgs.msg import TFMessage

from day6_core.ros.programs.robot_state_publisher._segments import Throttle
from day6_urdf import shipped_model
from rclpy.qos import DurabilityPolicy, QoSProfile, ReliabilityPolicy

if TYPE_CHECKING:
    from collections.abc import Callable

    from tests.robot.conftest import Machine

LATCHED = QoSProfile(depth=10, durability=DurabilityPolicy.TRANSIENT_LOCAL)

BOTH = ["left_wheel_joint", "right_wheel_joint"]
OTHER = (
    '<robot name="other"><link name="base"/><link name="arm"/><link name="tip"/>'
    '<joint name="lift" type="prismatic"><parent link="base"/><child link="arm"/><axis xyz="0 0 2"/>'
    '<limit upper="1" effort="1" velocity="1"/></joint>'
    '<joint name="hold" type="fixed"><parent link="arm"/><child link="tip"/><origin xyz="1 2 3"/></joint></robot>'
)
FALLBACK = (
    "[WARN] [robot_state_publisher]: No robot_description parameter, but command-line argument available."
    "  Assuming argument is name of URDF file.  This backwards compatibility fallback will be removed in the future.\n"
)


def frames(messages: list[Any]) -> list[list[tuple[str, str]]]:
    return [[(item.header.frame_id, item.child_frame_id) for item in message.transforms] for message in messages]


def set_parameter(machine: Machine, name: str, text: str) -> Any:
    value = ParameterValue(type=ParameterType.PARAMETER_STRING, string_value=text)
    request = [Parameter(name=name, value=value)]
    answer = machine.call(SetParameters, "/robot_state_publisher/set_parameters", parameters=request)
    machine.advance(0.01)
    return answer.results[0]


def test_it_starts_with_a_file_on_the_command_line_as_the_real_one_does(machine: Machine) -> None:
    running = machine.publish_robot()
    assert running.errors == FALLBACK + "[INFO] [robot_state_publisher]: Robot initialized\n"
    assert running.program.status is None


def test_the_description_waits_for_whoever_comes_late(machine: Machine) -> None:
    machine.publish_robot()
    machine.advance(5)
    heard = machine.watch(String, "/robot_description", LATCHED)
    assert [message.data for message in heard] == [shipped_model().read_text(encoding="utf-8")]


def test_only_the_fixed_joint_is_on_tf_static(machine: Machine) -> None:
    machine.publish_robot()
    heard = machine.watch(TFMessage, "/tf_static", LATCHED)
    assert frames(heard) == [[("base_link", "caster")]]
    place = heard[0].transforms[0].transform.translation
    assert (place.x, place.y, place.z) == (0.1, 0.0, 0.02)


def test_without_joint_states_there_is_nothing_on_tf(machine: Machine) -> None:
    machine.publish_robot()
    heard = machine.watch(TFMessage, "/tf")
    machine.advance(3)
    assert heard == []


def test_a_joint_state_becomes_a_transform_with_its_stamp(machine: Machine) -> None:
    machine.publish_robot()
    heard = machine.watch(TFMessage, "/tf")
    machine.joint_states(BOTH, [math.pi / 2, 4.0])
    assert frames(heard) == [[("base_link", "left_wheel"), ("base_link", "right_wheel")]]
    left, right = heard[0].transforms
    assert (left.transform.translation.y, left.transform.translation.z) == (0.15, 0.05)
    assert (left.transform.rotation.y, left.transform.rotation.w) == pytest.approx((math.sqrt(0.5), math.sqrt(0.5)))
    assert (right.transform.rotation.y, right.transform.rotation.w) == pytest.approx((math.sin(2), math.cos(2)))
    assert left.header.stamp.nanosec == 60_000_000


def test_a_joint_the_urdf_does_not_have_moves_nothing_and_nobody_complains(machine: Machine) -> None:
    running = machine.publish_robot()
    heard = machine.watch(TFMessage, "/tf")
    machine.joint_states(["wheel_left_joint", "right_wheel_joint"], [1.0, 1.0])
    machine.joint_states(["wheel_left_joint"], [1.0])
    assert frames(heard) == [[("base_link", "right_wheel")], []]
    assert running.errors.count("\n") == 2


def test_fifty_messages_a_second_give_a_transform_every_third(machine: Machine) -> None:
    # publish_frequency 20 means 50 ms; messages come every 20, so the first that is late enough is the third.
    machine.publish_robot()
    heard = machine.watch(TFMessage, "/tf")
    for _ in range(30):
        machine.joint_states(BOTH, [0.0, 0.0], after=0.02)
    assert len(heard) == 10


def test_a_message_without_a_stamp_is_never_due_unless_stamps_are_ignored(machine: Machine) -> None:
    running = machine.publish_robot()
    heard = machine.watch(TFMessage, "/tf")
    machine.joint_states(BOTH, [1.0, 1.0], stamp=False)
    assert heard == []
    running.program.kill()
    machine.publish_robot("--ros-args", "-p", "ignore_timestamp:=true")
    machine.joint_states(BOTH, [1.0, 1.0], stamp=False)
    assert len(heard) == 1


def test_publish_frequency_and_frame_prefix_are_parameters(machine: Machine) -> None:
    machine.publish_robot("--ros-args", "-p", "publish_frequency:=50.0", "-p", "frame_prefix:=robot1/")
    heard, fixed = machine.watch(TFMessage, "/tf"), machine.watch(TFMessage, "/tf_static", LATCHED)
    for _ in range(10):
        machine.joint_states(["left_wheel_joint"], [0.0], after=0.02)
    assert frames(heard) == [[("robot1/base_link", "robot1/left_wheel")]] * 10
    assert frames(fixed) == [[("robot1/base_link", "robot1/caster")]]


def test_its_parameters_are_those_of_the_original(machine: Machine) -> None:
    machine.publish_robot()
    listed = machine.call(ListParameters, "/robot_state_publisher/list_parameters").result.names
    overrides = sorted(name for name in listed if name.startswith("qos_overrides./") and "parameter_events" not in name)
    assert overrides == [
        *(f"qos_overrides./joint_states.subscription.{kind}" for kind in ("depth", "history", "reliability")),
        *(f"qos_overrides./tf.publisher.{kind}" for kind in ("depth", "durability", "history", "reliability")),
        *(f"qos_overrides./tf_static.publisher.{kind}" for kind in ("depth", "history", "reliability")),
    ]
    own = {"robot_description", "publish_frequency", "frame_prefix", "ignore_timestamp", "use_sim_time"}
    assert own <= set(listed)


def test_joint_states_are_heard_best_effort_and_tf_static_kept(machine: Machine) -> None:
    machine.publish_robot()
    (heard,) = machine.node.get_subscriptions_info_by_topic("/joint_states")
    (kept,) = machine.node.get_publishers_info_by_topic("/tf_static")
    assert heard.qos_profile.reliability == ReliabilityPolicy.BEST_EFFORT
    assert kept.qos_profile.durability == DurabilityPolicy.TRANSIENT_LOCAL


def test_messages_that_do_not_fit_are_named_in_the_real_words(machine: Machine) -> None:
    running = machine.publish_robot()
    machine.joint_states(BOTH, [1.0])
    machine.joint_states(BOTH, [])
    assert running.errors.splitlines()[2:] == [
        "[ERROR] [robot_state_publisher]: Robot state publisher ignored an invalid JointState message",
        (
            "[WARN] [robot_state_publisher]: Robot state publisher ignored a JointState message about joint(s)"
            ' "left_wheel_joint"(,...) whose position member was empty.'
        ),
    ]


def test_a_description_that_is_set_later_replaces_the_robot(machine: Machine) -> None:
    running = machine.publish_robot()
    moving = machine.watch(TFMessage, "/tf")
    described, fixed = (
        machine.watch(String, "/robot_description", LATCHED),
        machine.watch(TFMessage, "/tf_static", LATCHED),
    )
    assert set_parameter(machine, "robot_description", OTHER).successful
    assert described[-1].data == OTHER
    assert frames(fixed)[-1] == [("base_link", "caster"), ("arm", "tip")]  # tf2 keeps the old static frames
    machine.joint_states(["lift", "left_wheel_joint"], [0.5, 1.0])
    assert frames(moving) == [[("base", "arm")]]
    assert moving[0].transforms[0].transform.translation.z == 0.5
    assert running.errors.count("Robot initialized") == 2


def test_a_broken_description_that_is_set_later_is_refused_and_the_old_robot_stays(machine: Machine) -> None:
    running = machine.publish_robot()
    heard = machine.watch(TFMessage, "/tf")
    refused = set_parameter(machine, "robot_description", "<robot/>")
    assert (refused.successful, refused.reason) == (False, "Unable to initialize urdf::model from robot description")
    empty = set_parameter(machine, "robot_description", "")
    assert (empty.successful, empty.reason) == (False, "Empty URDF is not allowed")
    assert running.errors.splitlines()[2:] == [
        "Error:   No name given for the robot.",
        "         at line 119 in ./urdf_parser/src/model.cpp",
        "Failed to parse robot description using: urdf_xml_parser/URDFXMLParser",
        "[WARN] [robot_state_publisher]: Unable to initialize urdf::model from robot description",
    ]
    machine.joint_states(BOTH, [1.0, 1.0])
    assert len(heard) == 1


def test_a_frequency_out_of_range_is_refused(machine: Machine) -> None:
    machine.publish_robot()
    value = ParameterValue(type=ParameterType.PARAMETER_DOUBLE, double_value=1001.0)
    request = [Parameter(name="publish_frequency", value=value)]
    result = machine.call(SetParameters, "/robot_state_publisher/set_parameters", parameters=request).results[0]
    assert (result.successful, result.reason) == (False, "publish_frequency must be between 0.0 and 1000.0")
    dead = machine.publish_robot("--ros-args", "-r", "__node:=second", "-p", "publish_frequency:=-1.0")
    assert dead.errors.endswith("  what():  publish_frequency must be between 0 and 1000\n")


def died(machine: Machine, *args: str) -> str:
    """Start it so that it dies of an exception, as a C++ program does; return what it wrote."""
    running = machine.start("robot_state_publisher", "robot_state_publisher", *args)
    assert (running.program.status, running.program.killed_by) == (134, 6)
    machine.advance(0.1)
    assert [name for name in machine.node.get_node_names() if name == "robot_state_publisher"] == []
    return running.errors


def test_without_a_description_it_dies_saying_so(machine: Machine) -> None:
    assert died(machine) == (
        "[FATAL] [robot_state_publisher]: robot_description parameter must not be empty\n"
        "terminate called after throwing an instance of 'std::runtime_error'\n"
        "  what():  robot_description parameter must not be empty\n"
    )


def test_a_parameter_of_the_wrong_type_is_named_in_rclcpps_words(machine: Machine) -> None:
    assert died(machine, str(shipped_model()), "--ros-args", "-p", "publish_frequency:=20") == (
        FALLBACK
        + "terminate called after throwing an instance of 'rclcpp::exceptions::InvalidParameterTypeException'\n"
        "  what():  parameter 'publish_frequency' has invalid type: Wrong parameter type, parameter {publish_frequency}"
        " is of type {double}, setting it to {integer} is not allowed.\n"
    )


def test_a_missing_file_is_named(machine: Machine) -> None:
    assert died(machine, "no_such.urdf") == (
        FALLBACK
        + "[FATAL] [robot_state_publisher]: Failed to open URDF file: no_such.urdf: No such file or directory\n"
        "terminate called after throwing an instance of 'std::system_error'\n"
        "  what():  Failed to open URDF file: no_such.urdf: No such file or directory\n"
    )


@pytest.mark.parametrize(
    ("text", "said"),
    [
        (
            '<robot name="r"><link name="a">\n</robot>',
            (
                "Error:   Error=XML_ERROR_MISMATCHED_ELEMENT ErrorID=14 (0xe) Line number=1: XMLElement name=link\n"
                "         at line 101 in ./urdf_parser/src/model.cpp\n"
            ),
        ),
        (
            '<robot name="r"><link name="a"/><link name="b"/></robot>',
            (
                "Error:   Failed to find root link: Two root links found: [a] and [b]\n"
                "         at line 265 in ./urdf_parser/src/model.cpp\n"
            ),
        ),
        (
            "",
            (
                "Error:   Error=XML_ERROR_EMPTY_DOCUMENT ErrorID=13 (0xd) Line number=0\n"
                "         at line 101 in ./urdf_parser/src/model.cpp\n"
            ),
        ),
    ],
)
def test_a_malformed_file_is_explained_by_the_parser(machine: Machine, tmp_path: Path, text: str, said: str) -> None:
    file = tmp_path / "broken.urdf"
    file.write_text(text, encoding="utf-8")
    assert died(machine, str(file)) == (
        FALLBACK + said + "Failed to parse robot description using: urdf_xml_parser/URDFXMLParser\n"
        "terminate called after throwing an instance of 'std::runtime_error'\n"
        "  what():  Unable to initialize urdf::model from robot description\n"
    )


def test_a_loop_of_links_is_named_instead_of_hanging(machine: Machine, tmp_path: Path) -> None:
    joint = '<joint name="{0}" type="fixed"><parent link="{1}"/><child link="{2}"/></joint>'
    joints = joint.format("x", "a", "b") + joint.format("y", "b", "c") + joint.format("z", "c", "b")
    file = tmp_path / "loop.urdf"
    file.write_text(f'<robot name="r"><link name="a"/><link name="b"/><link name="c"/>{joints}</robot>')
    errors = died(machine, str(file))
    assert "The links form a loop: b -> c -> b\n" in errors
    assert errors.endswith("  what():  Failed to extract kdl tree from robot description\n")


def test_a_file_of_50_megabytes_is_refused_at_once(machine: Machine, tmp_path: Path) -> None:
    file = tmp_path / "huge.urdf"
    with file.open("wb") as writing:
        writing.truncate(50_000_000)
    assert "Error:   The robot description is too large: 50.0 MB, more than 4 MB are not read\n" in died(
        machine, str(file)
    )


def test_a_long_description_is_read_in_a_thread(machine: Machine, tmp_path: Path) -> None:
    links = "".join(f'<link name="l{n}"/>' for n in range(8000))
    joints = "".join(
        f'<joint name="j{n}" type="fixed"><parent link="l0"/><child link="l{n}"/></joint>' for n in range(1, 8000)
    )
    file = tmp_path / "long.urdf"
    file.write_text(f'<robot name="long">{links}{joints}</robot>')
    running = machine.start("robot_state_publisher", "robot_state_publisher", str(file))
    assert "Robot initialized" not in running.errors
    machine.until(lambda: "Robot initialized" in running.errors)
    assert len(machine.watch(TFMessage, "/tf_static", LATCHED)[0].transforms) == 7999


def test_kdls_warnings_are_printed(machine: Machine) -> None:
    inertial = '<inertial><mass value="1"/><inertia ixx="1" ixy="0" ixz="0" iyy="1" iyz="0" izz="1"/></inertial>'
    joint = '<joint name="{0}" type="{0}"><parent link="a"/><child link="{1}"/></joint>'
    text = (
        f'<robot name="r"><link name="a">{inertial}</link><link name="b"/><link name="c"/>'
        f"{joint.format('floating', 'b')}{joint.format('planar', 'c')}</robot>"
    )
    running = machine.start(
        "robot_state_publisher", "robot_state_publisher", "--ros-args", "-p", f"robot_description:='{text}'"
    )
    assert running.errors.splitlines() == [
        (
            "[WARN] [kdl_parser]: The root link a has an inertia specified in the URDF, but KDL does not support a root link"
            " with an inertia.  As a workaround, you can add an extra dummy link to your URDF."
        ),
        "[WARN] [kdl_parser]: Converting unknown joint type of joint 'floating' into a fixed joint",
        "[WARN] [kdl_parser]: Converting unknown joint type of joint 'planar' into a fixed joint",
        "[INFO] [robot_state_publisher]: Robot initialized",
    ]
    # Planar is published as fixed, floating not at all.
    assert frames(machine.watch(TFMessage, "/tf_static", LATCHED)) == [[("a", "c")]]


def test_mimic_joints_follow_the_joint_they_mimic(machine: Machine, tmp_path: Path) -> None:
    wheel = '<joint name="{0}" type="continuous"><parent link="a"/><child link="{1}"/><axis xyz="0 1 0"/>{2}</joint>'
    mimic = '<mimic joint="x" multiplier="-0.5" offset="0.25"/>'
    file = tmp_path / "mimic.urdf"
    file.write_text(
        f'<robot name="r"><link name="a"/><link name="b"/><link name="c"/>{wheel.format("x", "b", "")}'
        f"{wheel.format('y', 'c', mimic)}</robot>"
    )
    machine.start("robot_state_publisher", "robot_state_publisher", str(file))
    heard = machine.watch(TFMessage, "/tf")
    machine.joint_states(["x"], [1.0])
    assert [2 * math.asin(item.transform.rotation.y) for item in heard[0].transforms] == pytest.approx([1.0, -0.25])


@pytest.mark.parametrize(("frequency", "milliseconds"), [(20.0, 50), (30.0, 33), (1000.0, 1), (0.0, 0)])
def test_the_interval_is_whole_milliseconds(frequency: float, milliseconds: int) -> None:
    throttle = Throttle()
    then = 10_000_000_000
    throttle.note(["j"], then)
    due = then + milliseconds * 1_000_000
    assert throttle.admits(["j"], due, due, frequency)
    assert milliseconds == 0 or not throttle.admits(["j"], due - 1, due, frequency)
    assert throttle.admits(["j", "new"], then, due, frequency)  # a joint never seen waits from the beginning of time


def test_time_that_runs_backwards_is_told_and_everything_published_again() -> None:
    throttle = Throttle()
    second = 1_000_000_000
    assert not throttle.went_back(10 * second) and throttle.admits(["j"], 10 * second, 10 * second, 20.0)
    throttle.note(["j"], 10 * second)
    assert not throttle.admits(["j"], 5 * second, 10 * second, 20.0)
    assert throttle.went_back(5 * second) and throttle.admits(["j"], 5 * second, 5 * second, 20.0)


def test_ctrl_c_ends_it_as_a_cpp_node_ends(machine: Machine) -> None:
    running = machine.publish_robot()
    running.program.interrupt()
    machine.advance()
    assert running.program.status == 0
    assert running.errors.endswith("[INFO] [rclcpp]: signal_handler(SIGINT/SIGTERM)\n")


@pytest.mark.parametrize("name", ("kilted", "lyrical"))
def test_since_lyrical_the_description_may_come_from_the_topic(
    machine: Machine, in_distribution: Callable[[str], None], name: str
) -> None:
    in_distribution(name)
    running = machine.start(
        "robot_state_publisher", "robot_state_publisher", "--ros-args", "-p", "use_robot_description_topic:=true"
    )
    machine.advance(0.1)
    if name == "kilted":
        assert running.program.status is not None and "robot_description parameter must not be empty" in running.errors
        return
    moving, fixed = machine.watch(TFMessage, "/tf"), machine.watch(TFMessage, "/tf_static", LATCHED)
    publisher = machine.node.create_publisher(String, "robot_description", LATCHED)
    machine.joint_states(["lift"], [0.5])
    machine.advance(0.1)
    assert running.errors == "" and moving == fixed == []
    publisher.publish(String(data="<robot/>"))
    machine.advance(0.1)
    assert "Failed to parse new URDF: Unable to initialize urdf::model from robot description" in running.errors
    publisher.publish(String(data=OTHER))
    machine.advance(0.1)
    assert frames(fixed) == [[("arm", "tip")]]
    machine.joint_states(["lift"], [0.5])
    machine.advance(0.1)
    assert frames(moving) == [[("base", "arm")]]
