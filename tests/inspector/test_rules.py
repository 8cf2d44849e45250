"""What the inspector says about graphs that beginners make, and that it keeps quiet about healthy ones."""

from __future__ import annotations

import shlex
from dataclasses import replace
from pathlib import Path, PurePosixPath
from typing import Any, NamedTuple

import pytest

from day6_core.advice.card_files import all_cards, names_of
from day6_core.advice.wording import at_home
from day6_core.facts.graph import NodeAndType
from day6_core.interfaces import checks
from day6_core.ros.programs.day6_inspector import output_rules
from day6_core.ros.programs.day6_inspector.facts import RobotFacts, RVizView
from day6_core.ros.programs.day6_inspector.finding import finding
from day6_core.ros.programs.day6_inspector.hearing import Heard
from day6_core.ros.programs.day6_inspector.process_reports import Hidden, Place, ReportedProcess
from day6_core.ros.programs.day6_inspector.rules import RULES, Facts, findings
from day6_core.ros.programs.day6_inspector.sight import SIGHTS, not_seen, sights
from day6_core.ros.programs.day6_inspector.transforms import Transform
from day6_core.session.overview import TerminalView
from tests.support.folded import folded

TWIST, STRING, JOINTS = "geometry_msgs/msg/Twist", "std_msgs/msg/String", "sensor_msgs/msg/JointState"
WHEELS = frozenset({"left_wheel_joint", "right_wheel_joint"})


def texts(facts: Facts) -> list[str]:
    return [f"{each.level}: {each.text}" for each in findings(facts)]


def test_a_healthy_graph_has_nothing_wrong() -> None:
    topics = {"/turtle1/cmd_vel": (NodeAndType("/teleop_turtle", TWIST),)}
    facts = Facts(topics, {"/turtle1/cmd_vel": (NodeAndType("/turtlesim", TWIST),)}, ("/teleop_turtle", "/turtlesim"))
    assert texts(facts) == []


@pytest.mark.parametrize("wrong", ["/cmd_vel", "/turtle1/cmd_vle", "/turtle/cmd_vel"])
def test_a_slip_in_a_name_is_named_once_and_not_as_two_lonely_topics(wrong: str) -> None:
    facts = Facts({wrong: (NodeAndType("/driver", TWIST),)}, {"/turtle1/cmd_vel": (NodeAndType("/turtlesim", TWIST),)})
    assert texts(facts) == [
        f"warning: {wrong} is published and /turtle1/cmd_vel is subscribed to: is one of the names a typo?"
    ]


def test_alike_names_of_other_types_are_no_slip() -> None:
    facts = Facts({"/chatter": (NodeAndType("/talker", STRING),)}, {"/chattel": (NodeAndType("/turtlesim", TWIST),)})
    assert texts(facts) == [
        "info: /chattel: /turtlesim subscribes, but nobody publishes",
        "info: /chatter: /talker publishes, but nobody subscribes",
    ]


def test_nobody_misses_who_hears_of_rvizs_tools_but_a_program_that_sends_the_same_is_told() -> None:
    tools = {topic: (NodeAndType("/rviz", STRING),) for topic in ("/goal_pose", "/initialpose", "/clicked_point")}
    assert texts(Facts(tools, {})) == []
    facts = Facts({**tools, "/goal_pose": (NodeAndType("/rviz", STRING), NodeAndType("/planner", STRING))}, {})
    assert texts(facts) == ["info: /goal_pose: /rviz, /planner publishes, but nobody subscribes"]
    facts = Facts(tools, {"/goal_pos": (NodeAndType("/nav", STRING),)})
    assert texts(facts) == [
        "warning: /goal_pose is published and /goal_pos is subscribed to: is one of the names a typo?"
    ]


def test_types_that_do_not_match_keep_messages_away() -> None:
    facts = Facts({"/chatter": (NodeAndType("/talker", STRING),)}, {"/chatter": (NodeAndType("/listener", TWIST),)})
    assert texts(facts) == [f"error: /chatter: /talker sends {STRING}, /listener wants {TWIST}; nothing arrives"]


def test_qos_that_does_not_match_names_the_policy() -> None:
    endpoints = {"/scan": (NodeAndType("/lidar", STRING),)}
    facts = Facts(
        endpoints, {"/scan": (NodeAndType("/nav", STRING),)}, deaf=(("/scan", "/lidar", "/nav", "reliability"),)
    )
    assert texts(facts) == ["error: /scan: the QoS of /lidar is incompatible with /nav (reliability); nothing arrives"]


def test_two_publishers_of_joint_states_fight() -> None:
    endpoints = (NodeAndType("/wheel_spinner", JOINTS), NodeAndType("/joint_state_publisher_gui", JOINTS))
    facts = Facts({"/joint_states": endpoints}, {"/joint_states": (NodeAndType("/robot_state_publisher", JOINTS),)})
    assert texts(facts) == [
        (
            "warning: /joint_states: 2 nodes publish at the same time and fight over it: "
            "/wheel_spinner, /joint_state_publisher_gui"
        )
    ]


ROBOT = RobotFacts(moved=tuple((each, each.removesuffix("_joint")) for each in sorted(WHEELS)))
HEARD = {"/joint_states": (NodeAndType("/robot_state_publisher", JOINTS),)}
DESCRIBED = {"/robot_description": (NodeAndType("/robot_state_publisher", STRING),)}
LISTENED = {"/robot_description": (NodeAndType("/rviz", STRING),)}
VIEW = RVizView("base_link", ("base_link",), ("RobotModel",), True, "/robot_description", ("left_wheel",))


@pytest.mark.parametrize(
    ("names", "said"),
    [
        (
            ("left_wheel", "right_wheel_joint"),
            (
                "error: /joint_states: /turner names the joint left_wheel, which the robot description does not have, so "
                "TF has no place for left_wheel; did you mean left_wheel_joint?"
            ),
        ),
        (
            ("a", "b"),
            (
                "error: /joint_states: /turner names a, b, but the joints of the robot description are called left_wheel_joint, "
                "right_wheel_joint: TF has no place for left_wheel, right_wheel"
            ),
        ),
        (
            ("left_wheel_joint",),
            "warning: /joint_states: /turner doesn't send the position of right_wheel_joint, so TF has no place for right_wheel",
        ),
        (
            (*sorted(WHEELS), "arm"),
            "error: /joint_states: /turner names the joint arm, which the robot description does not have",
        ),
    ],
)
def test_my_wheels_are_missing_has_one_answer_with_joint_link_and_publisher(names: tuple[str, ...], said: str) -> None:
    ends = {"/joint_states": (NodeAndType("/turner", JOINTS),)}
    facts = Facts({**ends, **DESCRIBED}, {**HEARD, **LISTENED}, heard_joints=names, joints=WHEELS, robot=ROBOT)
    assert texts(facts) == [said]
    if "left_wheel_joint" not in names:
        assert texts(replace(facts, rviz=(VIEW,))) == [said], "RViz has no second answer"


def test_nobody_publishes_joint_states_is_an_error_where_rviz_waits_for_them() -> None:
    facts = Facts(DESCRIBED, {**HEARD, **LISTENED}, joints=WHEELS, robot=ROBOT)
    said = "nobody publishes /joint_states, so nothing says how far these joints have moved: left_wheel_joint, right_wheel_joint"
    assert [text.startswith(f"info: {said}") for text in texts(facts)] == [True]
    assert [text.startswith(f"error: {said}") for text in texts(replace(facts, rviz=(VIEW,)))] == [True]


TREE = (Transform("odom", "base_link", ("/base",)), Transform("base_link", "laser", ("/base",)))
SCAN, ODOMETRY = "sensor_msgs/msg/LaserScan", "nav_msgs/msg/Odometry"
WALL, TICKS = 1_700_000_000.0, {"/clock": (NodeAndType("/robot", "rosgraph_msgs/msg/Clock"),)}
MAPPED = {
    "/scan": (NodeAndType("/slam", SCAN),),
    "/tf": (NodeAndType("/slam", "tf2_msgs/msg/TFMessage"),),
}


def says(stamp: float | None = None, ahead: float = 0.0, frames: tuple[str, ...] = (), **more: Any) -> Heard:
    return Heard("/scan", "/robot", SCAN, stamp=stamp, ahead=ahead, frames=frames, **more)


FOUND: dict[str, tuple[Facts, str]] = {
    "a tree": (Facts(transforms=TREE), ""),
    "a loop": (Facts(transforms=(*TREE, Transform("laser", "odom", ("/a",)))), "error tf_loop"),
    "a frame in itself": (Facts(transforms=(Transform("a", "a", ("/a",)),)), "error tf_loop"),
    "two parents": (Facts(transforms=(*TREE, Transform("map", "base_link", ("/a",)))), "error two_parents"),
    "no name": (Facts(transforms=(Transform("", "a", ("/a",)),)), "error tf_nameless"),
    "two that differ": (Facts(transforms=(Transform("a", "b", ("/a", "/b"), apart=True),)), "warning tf_fight"),
    "two that agree": (Facts(transforms=(Transform("a", "b", ("/a", "/b")),)), ""),
    "known": (Facts(heard=(says(frames=("/laser",)),), transforms=TREE, frames=frozenset({"laser"})), ""),
    "a slip": (
        Facts(heard=(says(frames=("lasr",)),), transforms=TREE, frames=frozenset({"laser"})),
        "warning unknown_frame_near",
    ),
    "elsewhere": (
        Facts(heard=(says(frames=("x",)),), transforms=TREE, frames=frozenset({"laser"})),
        "info unknown_frame",
    ),
    "placed": (
        Facts({}, MAPPED, heard=(says(frames=("x",)),), transforms=TREE, frames=frozenset({"laser"})),
        "warning unknown_frame",
    ),
    "nowhere": (Facts(heard=(says(frames=("",)),), transforms=TREE), "info empty_frame"),
    "without any transform": (Facts(heard=(says(frames=("x",)),)), ""),
    "now": (Facts(heard=(says(WALL, 0.5),)), ""),
    "no stamp": (Facts(heard=(says(0.0, -WALL),)), "info stampless"),
    "1970": (Facts(heard=(says(5.0, 5.0 - WALL),)), "warning stamp_1970"),
    "an hour ago": (Facts(heard=(says(WALL - 3600, -3600),)), "warning stamp_past"),
    "in an hour": (Facts(heard=(says(WALL + 3600, 3600),)), "warning stamp_future"),
    "a bag": (Facts(heard=(says(WALL - 3600, -3600)._replace(node="/rosbag2_player"),)), ""),
    "by the simulator": (Facts({"/clock": ()}, TICKS, heard=(says(5.0, 5.0 - WALL),), clock=5.0), ""),
    "beside the simulator": (Facts(heard=(says(WALL),), clock=5.0), "warning stamp_clock"),
    "a clock that is right": (Facts(heard=(says(WALL),), clock=WALL + 1), ""),
    "rivals": (Facts(rival_descriptions=("/a", "/b")), "error two_descriptions"),
}


@folded("case", FOUND.items(), ids=lambda case: case[0])
def test_transforms_frames_and_stamps(case: tuple[str, tuple[Facts, str]]) -> None:
    _, (facts, said) = case
    found = [f"{each.level} {each.id.removeprefix('inspector.')}" for each in findings(facts)]
    assert [each for each in found if "unsaid" not in each] == ([said] if said else [])


def test_joints_stay_within_their_limits_and_a_trajectory_knows_its_robot() -> None:
    robot = RobotFacts(limits=(("arm", (-1.5, 1.5)),))
    near, far = (Heard("/j", "/a", JOINTS, joints=(("arm", position),)) for position in (1.51, 90.0))
    assert texts(Facts(heard=(near,), robot=robot, joints=frozenset({"arm"}))) == []
    (said,) = texts(Facts(heard=(far,), robot=robot, joints=frozenset({"arm"})))
    assert "90 for arm, whose limits are -1.5 and 1.5" in said
    order = Heard("/t", "/a", "trajectory_msgs/msg/JointTrajectory", joints=(("arm", 0.0), ("am", 0.0)))
    (said,) = texts(Facts(heard=(order,), robot=robot, joints=frozenset({"arm"})))
    assert "the joint am, which the robot doesn't have; did you mean arm?" in said


def test_every_rule_says_what_it_looks_at_and_nothing_is_counted_that_no_rule_looks_at() -> None:
    declared = {sight for rule in RULES for sight in rule.of}
    assert declared == SIGHTS.keys()
    assert all(rule.of for rule in RULES if rule.judge.__name__ != "_late"), "the clock is always there"
    counts = dict(sights(RULES, Facts({"/a": ()}, {"/b": ()}, ("/n",))))
    assert counts["topics"] == 2 and counts["nodes"] == 1 and counts["joints"] == 0
    assert "terminals" not in counts and "packages" not in counts, "nobody could look at them"
    assert ("terminals", "") in not_seen(Facts()) and ("programs", "/a") in not_seen(Facts(unreported=("/a",)))


def test_movement_of_one_hertz_is_slow() -> None:
    endpoints = {"/joint_states": (NodeAndType("/wheel_spinner", JOINTS),)}
    facts = Facts(
        endpoints, {"/joint_states": (NodeAndType("/robot_state_publisher", JOINTS),)}, rates={"/joint_states": 1.0}
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


class Ran(NamedTuple):
    """A line of a terminal."""

    output: str
    status: int | None = None
    source: str = "ros2 run my_pkg follower"
    number: int = 1
    cwd: Path = Path("/")
    began_ns: int = 0

    @property
    def ended_ns(self) -> int | None:
        return None if self.status is None else NOW


NOW = 1_700_000_000 * 10**9
ECHO = 'Invalid frame ID "carrot" passed to canTransform argument target_frame - frame does not exist\n'
LOOKED_UP = '"carrot" passed to lookupTransform argument source_frame does not exist.\n'
LATE = "[INFO] [{at}] [follower]: Lookup would require extrapolation into the future.\n"


def keys_after(*lines: Ran, **more: object) -> list[str]:
    running = [line.source for line in lines if line.status is None]
    terminal = TerminalView(1, Path("/"), {}, lines, running, 1)
    facts = Facts(terminals=(terminal,), now_ns=NOW, **more)  # type: ignore[arg-type]
    return [each.id.removeprefix("inspector.") for each in findings(facts)]


@pytest.mark.parametrize("said", [ECHO, LOOKED_UP])
def test_a_frame_that_came_after_the_program_had_asked_for_it_is_no_fault(said: str) -> None:
    assert keys_after(Ran(said)) == ["no_frame"]
    assert keys_after(Ran(said), frames=frozenset({"world", "carrot"})) == []
    assert keys_after(Ran(said), frames=frozenset({"world"})) == ["no_frame"]
    assert keys_after(Ran(said + "At time 17.5\n- Translation: [0.0, 0.0, 0.0]\n" * 3)) == []
    assert keys_after(Ran(said + "At time 17.5\n- Translation: [0.0, 0.0, 0.0]\n" * 3 + "^C\n", status=130)) == []
    ended = Ran(said, status=1)
    assert keys_after(ended, frames=frozenset({"carrot"})) == ["no_frame"], "it ended of it"


def test_an_extrapolation_is_a_fault_as_long_as_the_program_complains_of_it() -> None:
    new, old = LATE.format(at="1699999998.5"), LATE.format(at="1699999980.5")
    assert keys_after(Ran(new)) == keys_after(Ran(old + new)) == ["extrapolation"]
    assert keys_after(Ran(old)) == [], "it would have said so again"
    assert keys_after(Ran(new + "going on\n" * 4)) == []
    assert keys_after(Ran(old, status=1)) == ["extrapolation"]


def test_a_fault_is_placed_in_the_students_program_also_where_this_one_is_a_checkout() -> None:
    own = Path(checks.__file__)
    said = f"""Traceback (most recent call last):
  File "/home/a/program.py", line 7, in <module>
  File "{own}", line 76, in _check_single
AssertionError: The 'x' field must be of type 'float'
"""
    terminal = TerminalView(1, Path("/"), {}, [Ran(said, 1, "python3 program.py")], [], 1)
    (found,) = findings(Facts(terminals=(terminal,), now_ns=NOW))
    assert found.next == f"nano +7 {shlex.quote(str(Path('/home/a/program.py')))}"
    assert dict(found.parameters)["where"] == "program.py:7"


@pytest.mark.parametrize(("reported", "count"), [("Thread-1 (work)", 1), ("Thread-7 (other)", 2)])
def test_a_thread_that_died_is_told_once(reported: str, count: int) -> None:
    said = """Exception in thread Thread-1 (work):
Traceback (most recent call last):
  File "/home/a/program.py", line 7, in work
KeyError: 'speed'
"""
    hidden = Hidden("", "KeyError: 'speed'", Place("/home/a/program.py", 7), reported)
    process = ReportedProcess("z", 1, ("/home/a/program.py",), hidden=(hidden,))
    assert keys_after(Ran(said), processes=(process,)) == ["thread_died"] * count


def test_two_types_are_told_as_long_as_there_are_two() -> None:
    said = Ran("Cannot echo topic '/score', as it contains more than one type: [a, b]", 1, "ros2 topic echo /score")
    number = {"/score": (NodeAndType("/board", "std_msgs/msg/Int32"),)}
    assert "two_types_said" in keys_after(
        said, publishers={"/score": (*number["/score"], NodeAndType("/text", STRING))}
    )
    assert "two_types_said" not in keys_after(said, publishers=number)


def test_a_command_that_went_well_takes_the_place_of_its_failed_attempts() -> None:
    wrong = Ran(
        "Setting parameter failed: Wrong parameter type, expected double", 1, "ros2 param set /heater target 25"
    )
    right = Ran("Set parameter successful", 0, "ros2 param set /heater target 25.0")
    other = Ran("", 0, "ros2 param get /heater target")
    assert keys_after(wrong) == keys_after(wrong, other) == keys_after(right, wrong) == ["parameter_type"]
    assert keys_after(wrong, right) == keys_after(wrong, right, other) == []


def test_what_a_finding_names_is_found_by_every_pattern_of_its_card_unless_a_judge_fills_it_in() -> None:
    cards = [card for card in all_cards() if card.finding]
    assert output_rules._JUDGES.keys() <= {card.finding for card in cards}
    for card in cards:
        if card.finding not in output_rules._JUDGES:
            named = names_of(card.words["en"].finding) - {"where", "line"}
            assert all(named <= pattern.names for pattern in card.finds or card.patterns), card.id


def test_paths_are_told_as_they_are_typed() -> None:
    folder = PurePosixPath("/tmp/x/home/ros2_ws/src/car")
    said = {"line": "ros2 run car go", "package": "car", "folder": folder}
    found = finding("error", "not_built", **said, then="cd /tmp/x/home/ros2_ws && colcon build").at_home("/tmp/x/home")
    assert found.next == "cd ~/ros2_ws && colcon build" and "~/ros2_ws/src/car" in found.text
    assert "/tmp" not in found.text and dict(found.parameters).keys() == said.keys()
    assert found.at_home("") == found


@pytest.mark.parametrize(
    ("said", "told"),
    [
        (r"car is in C:\a b\home\ros2_ws\src\car, not built", "car is in ~/ros2_ws/src/car, not built"),
        (r"cd 'C:\a b\home\ros2_ws' && colcon build", "cd ~/ros2_ws && colcon build"),
        (r"nano +3 'C:\a b\home'", "nano +3 ~"),
        (r"in C:\a b\homes\x", r"in C:\a b\homes\x"),
    ],
)
def test_paths_of_windows_are_told_as_a_shell_takes_them(said: str, told: str) -> None:
    assert at_home(said, "C:\\a b\\home", "\\") == told
