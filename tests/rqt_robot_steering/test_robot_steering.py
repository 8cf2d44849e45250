"""Robot Steering: what it publishes and when, its limits and perspectives, topics that are wrong, the turtle it drives."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from pathlib import Path

import pytest
from geometry_msgs.msg import Twist, TwistStamped
from std_msgs.msg import String
from turtlesim.msg import Pose

from day6_core.ros.programs.rqt_gui.plugin import PluginPlace
from day6_core.ros.programs.rqt_robot_steering.model import ANGULAR, LINEAR, MAXIMUM, MINIMUM, Axis
from day6_core.ros.programs.rqt_robot_steering.rqt_robot_steering import RobotSteeringPlugin
from tests.support.rqt_machine import RqtMachine


@pytest.fixture
def machine(tmp_path: Path) -> Iterator[RqtMachine]:
    found = RqtMachine("rqt_robot_steering", tmp_path)
    yield found
    found.end()


def velocities(messages: list[Twist]) -> list[tuple[float, float]]:
    return [(each.linear.x, each.angular.z) for each in messages]


def test_zero_is_published_once_and_a_velocity_ten_times_a_second(machine: RqtMachine) -> None:
    seen = machine.watch(Twist, "/cmd_vel")
    machine.open(seconds=1.05)
    assert velocities(seen) == [(0.0, 0.0)]
    machine.do("set", LINEAR, 250, seconds=1.0)
    assert velocities(seen[1:]) == [(0.25, 0.0)] * 11, "at once, and then ten times"
    machine.do("set", ANGULAR, -1500, seconds=0.0)
    assert velocities(seen)[-1] == (0.25, -1.5)
    message = seen[-1]
    assert (message.linear.y, message.linear.z, message.angular.x, message.angular.y) == (0.0, 0.0, 0.0, 0.0)


def test_stop_goes_through_zero_and_then_others_can_drive(machine: RqtMachine) -> None:
    seen = machine.watch(Twist, "/cmd_vel")
    machine.open()
    machine.do("set", LINEAR, 100, seconds=0.0)
    machine.do("set", ANGULAR, 200, seconds=0.0)
    seen.clear()
    machine.do("stop", seconds=1.0)
    assert velocities(seen) == [(0.0, 0.2), (0.0, 0.0)], "one slider after the other, as in the real one"
    machine.do("stop", seconds=1.0)
    assert velocities(seen[2:]) == [(0.0, 0.0)], "who presses Stop again wants to be sure"


def test_sliders_move_by_steps_and_stay_between_their_ends(machine: RqtMachine) -> None:
    machine.open()
    machine.do("move", LINEAR, 100)
    machine.do("move", LINEAR, -10)
    assert machine.model.axes == {LINEAR: Axis(-1000, 1000, 90), ANGULAR: Axis(-3000, 3000, 0)}
    machine.do("move", LINEAR, 5000)
    machine.do("move", ANGULAR, -5000)
    assert (machine.model.axes[LINEAR].value, machine.model.axes[ANGULAR].value) == (1000, -3000)


def test_an_end_that_comes_nearer_takes_the_slider_along(machine: RqtMachine) -> None:
    seen = machine.watch(Twist, "/cmd_vel")
    machine.open()
    machine.do("set", LINEAR, 1000, seconds=0.0)
    machine.do("set_limit", LINEAR, MAXIMUM, 0.22, seconds=0.0)
    assert machine.model.axes[LINEAR] == Axis(-1000, 220, 220) and velocities(seen)[-1] == (0.22, 0.0)
    for end, given, kept in (
        (MAXIMUM, 99.0, 10_000), (MAXIMUM, -1.0, 0), (MINIMUM, -99.0, -10_000), (MINIMUM, 1.0, 0), (MINIMUM, float("nan"), 0),
    ):  # fmt: skip
        machine.do("set_limit", LINEAR, end, given)
        assert getattr(machine.model.axes[LINEAR], end) == kept
    assert velocities(seen)[-1] == (0.0, 0.0)


def test_stamped_messages_have_the_time_and_take_the_place_of_the_others(machine: RqtMachine) -> None:
    machine.open()
    machine.do("set", LINEAR, 500)
    plain = machine.watch(Twist, "/cmd_vel")
    machine.do("set_stamped", True)
    stamped: list[TwistStamped] = []
    machine.other("listener").node.create_subscription(TwistStamped, "/cmd_vel", stamped.append, 10)
    plain.clear()
    machine.advance(0.5)
    assert plain == [] and stamped[-1].twist.linear.x == 0.5 and stamped[-1].header.frame_id == ""
    assert stamped[-1].header.stamp.sec > 0
    kinds = [info.topic_type for info in machine.node.get_publishers_info_by_topic("/cmd_vel")]
    assert kinds == ["geometry_msgs/msg/TwistStamped"]


def test_another_topic_gets_the_velocity_and_the_old_one_no_more(machine: RqtMachine) -> None:
    machine.open()
    machine.do("set", LINEAR, 500)
    old, new = machine.watch(Twist, "/cmd_vel"), machine.watch(Twist, "/turtle1/cmd_vel")
    machine.do("set_topic", "turtle1/cmd_vel")
    old.clear()
    machine.advance(0.5)
    assert old == [] and len(new) >= 5 and machine.model.heard == 1
    machine.do("set_topic", "")
    new.clear()
    machine.advance(0.5)
    assert new == [] and machine.node.count_publishers("/turtle1/cmd_vel") == 0


def test_a_topic_that_is_no_name_is_told_in_rclpys_words(machine: RqtMachine) -> None:
    running = machine.open()
    machine.do("set_topic", "/cmd vel")
    assert machine.model.problem.startswith("Invalid topic name: topic name must not contain characters other than")
    assert running.output.startswith("Error creating publisher: Invalid topic name")
    machine.do("set", LINEAR, 100)
    machine.do("set_topic", "/cmd_vel")
    assert machine.model.problem == ""


def test_a_topic_of_another_type_is_told_as_long_as_it_has_one(machine: RqtMachine) -> None:
    machine.open()
    machine.do("set_topic", "/chatter")
    publisher = machine.node.create_publisher(String, "/chatter", 10)
    machine.advance(0.3)
    assert machine.model.other_types == ("std_msgs/msg/String",) and machine.model.heard == 0
    machine.node.destroy_publisher(publisher)
    machine.advance(0.3)
    assert machine.model.other_types == ()


def test_a_topic_that_its_own_node_uses_with_another_type_is_told_in_the_words_of_rcl(machine: RqtMachine) -> None:
    plugin = RobotSteeringPlugin(PluginPlace(machine._programs[0].session, machine.node, settings={"topic": "/mine"}))
    machine.node.create_subscription(Twist, "/mine", print, 10)
    plugin.model.set_stamped(True)
    plugin.model.handle()
    assert "existing topic name rt/mine with incompatible type" in plugin.model.problem
    plugin.model.publish()
    plugin.model.set_stamped(False)
    plugin.model.handle()
    assert plugin.model.problem == "" and plugin.model.heard == 1
    plugin.close()


def test_it_drives_the_turtle(machine: RqtMachine) -> None:
    machine.start("turtlesim", "turtlesim_node", screen=False)
    poses = machine.watch(Pose, "/turtle1/pose")
    machine.open()
    machine.do("set_topic", "/turtle1/cmd_vel")
    machine.do("set", LINEAR, 1000, seconds=2.0)
    assert poses[-1].x == pytest.approx(5.544445 + 2.0, abs=0.1)
    machine.do("stop", seconds=0.1)
    assert poses[-1].linear_velocity == 0.0


def test_closing_publishes_nothing_as_the_real_one(machine: RqtMachine) -> None:
    seen = machine.watch(Twist, "/cmd_vel")
    running = machine.open()
    machine.do("set", LINEAR, 1000, seconds=0.0)
    seen.clear()
    machine.display.windows[0].close_by_user()
    machine.advance(1.0)
    assert running.program.status == 130 and seen == []
    assert machine.node.count_publishers("/cmd_vel") == 0


@pytest.mark.parametrize(
    ("kept", "restored"),
    [
        ({}, {"topic": "/cmd_vel", "stamped": False, "vx_max": 1.0, "vx_min": -1.0, "vw_max": 3.0, "vw_min": -3.0}),
        (
            {"topic": "/robot/cmd_vel", "stamped": True, "vx_max": 0.22, "vx_min": 0.0, "vw_max": 10, "vw_min": -0.5},
            {"topic": "/robot/cmd_vel", "stamped": True, "vx_max": 0.22, "vx_min": 0.0, "vw_max": 10.0, "vw_min": -0.5},
        ),
        (
            {"topic": 5, "stamped": "true", "vx_max": "far", "vx_min": 1e300, "vw_max": float("nan"), "vw_min": None},
            {"topic": "/cmd_vel", "stamped": True, "vx_max": 1.0, "vx_min": 0.0, "vw_max": 3.0, "vw_min": -3.0},
        ),
    ],
)
def test_a_perspective_brings_topic_type_and_limits_back(machine: RqtMachine, kept: dict, restored: dict) -> None:
    machine.open()
    plugin = RobotSteeringPlugin(PluginPlace(machine._programs[0].session, machine.node, settings=kept))
    assert plugin.settings() == restored
    plugin.close()


def test_without_a_screen_it_is_a_node(machine: RqtMachine) -> None:
    running = machine.start("rqt_robot_steering", "rqt_robot_steering")
    machine.advance(0.5)
    assert "There is no screen for the window" in running.errors
    assert machine.node.count_publishers("/cmd_vel") == 1


GIVEN = ("--ros-args", "-p", "default_topic:=/mine", "-p", "default_stamped:=false", "-p", "default_vx_max:=2.2")


@pytest.mark.parametrize(
    ("distribution", "words", "topic", "stamped", "fastest"),
    [
        ("humble", (), "/cmd_vel", False, 1000),
        ("jazzy", GIVEN, "/cmd_vel", False, 1000),
        ("lyrical", (), "/cmd_vel", True, 1000),
        ("lyrical", GIVEN, "/mine", False, 2200),
    ],
)
def test_it_begins_as_that_of_its_distribution(
    machine: RqtMachine, in_distribution: Callable[[str], None], distribution, words, topic, stamped, fastest
) -> None:
    in_distribution(distribution)
    machine.open(*words)
    model = machine.model
    assert (model.topic, model.stamped, model.axes[LINEAR].maximum) == (topic, stamped, fastest)


def test_a_parameter_of_the_wrong_type_is_told_in_rclpys_words(
    machine: RqtMachine, in_distribution: Callable[[str], None]
) -> None:
    in_distribution("lyrical")
    running = machine.start(
        "rqt_robot_steering",
        "rqt_robot_steering",
        "--ros-args",
        "-p",
        "default_vx_max:=2",
        screen=True,
        home=machine.folder,
    )
    assert running.program.status == 1 and "expecting type 'DOUBLE'" in running.errors
