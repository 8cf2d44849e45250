"""What the inspector says about graphs that beginners make, and that it keeps quiet about healthy ones."""

from __future__ import annotations

import pytest

from day6_tui.core.ros.programs.day6_inspector.rules import Endpoint, Facts, findings

TWIST, STRING, JOINTS = "geometry_msgs/msg/Twist", "std_msgs/msg/String", "sensor_msgs/msg/JointState"
WHEELS = frozenset({"left_wheel_joint", "right_wheel_joint"})


def texts(facts: Facts) -> list[str]:
    return [f"{finding.level}: {finding.text}" for finding in findings(facts)]


def test_a_healthy_graph_has_nothing_wrong() -> None:
    topics = {"/turtle1/cmd_vel": (Endpoint("/teleop_turtle", TWIST),)}
    facts = Facts(topics, {"/turtle1/cmd_vel": (Endpoint("/turtlesim", TWIST),)}, ("/teleop_turtle", "/turtlesim"))
    assert texts(facts) == []


@pytest.mark.parametrize("wrong", ["/cmd_vel", "/turtle1/cmd_vle", "/turtle/cmd_vel"])
def test_a_slip_in_a_name_is_named_once_and_not_as_two_lonely_topics(wrong: str) -> None:
    facts = Facts({wrong: (Endpoint("/driver", TWIST),)}, {"/turtle1/cmd_vel": (Endpoint("/turtlesim", TWIST),)})
    assert texts(facts) == [
        f"warning: {wrong} is published and /turtle1/cmd_vel is subscribed to: is one of the names a typo?"
    ]


def test_alike_names_of_other_types_are_no_slip() -> None:
    facts = Facts({"/chatter": (Endpoint("/talker", STRING),)}, {"/chattel": (Endpoint("/turtlesim", TWIST),)})
    assert texts(facts) == [
        "info: /chattel: /turtlesim subscribes, but nobody publishes",
        "info: /chatter: /talker publishes, but nobody subscribes",
    ]


def test_types_that_do_not_match_keep_messages_away() -> None:
    facts = Facts({"/chatter": (Endpoint("/talker", STRING),)}, {"/chatter": (Endpoint("/listener", TWIST),)})
    assert texts(facts) == [f"error: /chatter: /talker sends {STRING}, /listener wants {TWIST}; nothing arrives"]


def test_qos_that_does_not_match_names_the_policy() -> None:
    endpoints = {"/scan": (Endpoint("/lidar", STRING),)}
    facts = Facts(endpoints, {"/scan": (Endpoint("/nav", STRING),)}, deaf=(("/scan", "/lidar", "/nav", "reliability"),))
    assert texts(facts) == ["error: /scan: the QoS of /lidar is incompatible with /nav (reliability); nothing arrives"]


def test_two_publishers_of_joint_states_fight() -> None:
    endpoints = (Endpoint("/wheel_spinner", JOINTS), Endpoint("/joint_state_publisher_gui", JOINTS))
    facts = Facts({"/joint_states": endpoints}, {"/joint_states": (Endpoint("/robot_state_publisher", JOINTS),)})
    assert texts(facts) == [
        (
            "warning: /joint_states: 2 nodes publish at the same time and fight over it: "
            "/wheel_spinner, /joint_state_publisher_gui"
        )
    ]


def test_a_joint_the_robot_does_not_have_is_named_with_its_neighbour() -> None:
    facts = Facts(heard_joints=("left_wheel", "right_wheel_joint"), joints=WHEELS)
    assert texts(facts) == [
        (
            "error: /joint_states names the joint left_wheel, which the robot description does not have; "
            "did you mean left_wheel_joint?"
        ),
        "warning: the joint left_wheel_joint can move, but nobody sends its position on /joint_states",
    ]


def test_movement_of_one_hertz_is_slow() -> None:
    endpoints = {"/joint_states": (Endpoint("/wheel_spinner", JOINTS),)}
    facts = Facts(
        endpoints, {"/joint_states": (Endpoint("/robot_state_publisher", JOINTS),)}, rates={"/joint_states": 1.0}
    )
    assert texts(facts) == ["info: /joint_states arrives 1 times a second; the eye needs about 20"]


@pytest.mark.parametrize(
    ("pace", "speed", "told"),
    [(0.62, 1.0, "0.62x instead of 1x"), (1.7, 2.0, "1.7x instead of 2x"), (0.95, 1.0, ""), (0.1, 0.1, "")],
)
def test_a_computer_that_does_not_keep_up_is_told_with_how_fast_time_passes(
    pace: float, speed: float, told: str
) -> None:
    said = texts(Facts(pace=pace, speed=speed))
    assert [told in line for line in said] == ([True] if told else [])


def test_two_nodes_of_one_name_are_told() -> None:
    assert texts(Facts(nodes=("/talker", "/talker", "/listener"))) == [
        "warning: 2 nodes are called /talker: lists and parameters cannot tell them apart"
    ]
