"""What the inspector says about graphs that beginners make, and that it keeps quiet about healthy ones."""

from __future__ import annotations

import pytest

from day6_tui.core.ros.programs.day6_inspector._rules import TEXTS, End, Facts, findings
from day6_tui.tui.locale.en import TEXTS as EN

TWIST, STRING, JOINTS = "geometry_msgs/msg/Twist", "std_msgs/msg/String", "sensor_msgs/msg/JointState"
WHEELS = frozenset({"left_wheel_joint", "right_wheel_joint"})


def said(facts: Facts) -> list[str]:
    return [f"{finding.level}: {finding.text}" for finding in findings(facts)]


def test_a_healthy_graph_has_nothing_wrong() -> None:
    topics = {"/turtle1/cmd_vel": (End("/teleop_turtle", TWIST),)}
    facts = Facts(topics, {"/turtle1/cmd_vel": (End("/turtlesim", TWIST),)}, ("/teleop_turtle", "/turtlesim"))
    assert said(facts) == []


@pytest.mark.parametrize("wrong", ["/cmd_vel", "/turtle1/cmd_vle", "/turtle/cmd_vel"])
def test_a_slip_in_a_name_is_named_once_and_not_as_two_lonely_topics(wrong: str) -> None:
    facts = Facts({wrong: (End("/driver", TWIST),)}, {"/turtle1/cmd_vel": (End("/turtlesim", TWIST),)})
    assert said(facts) == [
        f"warning: {wrong} is published and /turtle1/cmd_vel is listened to: is one of the names a slip?"
    ]


def test_alike_names_of_other_types_are_no_slip() -> None:
    facts = Facts({"/chatter": (End("/talker", STRING),)}, {"/chattel": (End("/turtlesim", TWIST),)})
    assert said(facts) == [
        "warning: /chattel: /turtlesim listens, nobody publishes",
        "info: /chatter: /talker publishes, nobody listens",
    ]


def test_types_that_do_not_match_keep_messages_away() -> None:
    facts = Facts({"/chatter": (End("/talker", STRING),)}, {"/chatter": (End("/listener", TWIST),)})
    assert said(facts) == [f"error: /chatter: /talker sends {STRING}, /listener wants {TWIST}; nothing arrives"]


def test_qos_that_does_not_match_names_the_policy() -> None:
    ends = {"/scan": (End("/lidar", STRING),)}
    facts = Facts(ends, {"/scan": (End("/nav", STRING),)}, deaf=(("/scan", "/lidar", "/nav", "reliability"),))
    assert said(facts) == ["error: /scan: the QoS of /lidar does not suit /nav (reliability); nothing arrives"]


def test_two_publishers_of_joint_states_fight() -> None:
    ends = (End("/wheel_spinner", JOINTS), End("/joint_state_publisher_gui", JOINTS))
    facts = Facts({"/joint_states": ends}, {"/joint_states": (End("/robot_state_publisher", JOINTS),)})
    assert said(facts) == [
        (
            "warning: /joint_states: 2 nodes publish at the same time and fight over it: "
            "/wheel_spinner, /joint_state_publisher_gui"
        )
    ]


def test_a_joint_the_robot_does_not_have_is_named_with_its_neighbour() -> None:
    facts = Facts(heard_joints=("left_wheel", "right_wheel_joint"), joints=WHEELS)
    assert said(facts) == [
        (
            "error: /joint_states names the joint left_wheel, which the robot description does not have; "
            "did you mean left_wheel_joint?"
        ),
        "warning: the joint left_wheel_joint can move, but nobody sends its position on /joint_states",
    ]


def test_movement_of_one_hertz_is_slow() -> None:
    ends = {"/joint_states": (End("/wheel_spinner", JOINTS),)}
    facts = Facts(ends, {"/joint_states": (End("/robot_state_publisher", JOINTS),)}, rates={"/joint_states": 1.0})
    assert said(facts) == ["info: /joint_states comes 1 times a second; the eye needs about 20"]


def test_two_nodes_of_one_name_are_told() -> None:
    assert said(Facts(nodes=("/talker", "/talker", "/listener"))) == [
        "warning: 2 nodes are called /talker: lists and parameters cannot tell them apart"
    ]


def test_the_window_says_the_same_words() -> None:
    assert {key: EN[key] for key in TEXTS} == TEXTS
