"""The Message Publisher: rates, expressions computed for each message, perspectives; on a clock that the test moves."""

from __future__ import annotations

import ast
from collections.abc import Iterator
from typing import Any

import pytest
from builtin_interfaces.msg import Time
from geometry_msgs.msg import Polygon, PoseStamped, PoseWithCovariance, Twist
from std_msgs.msg import Bool, ByteMultiArray, Float64MultiArray, Int32, String, UInt8
from test_msgs.msg import BoundedSequences

from day6_core.graph import Graph
from day6_core.interfaces import type_name
from day6_core.ros.programs.rqt_gui.plugin import PluginPlace
from day6_core.ros.programs.rqt_publisher import model, rqt_publisher
from day6_core.session.clock import WorldClock
from day6_core.session.display import Display
from day6_core.session.program import Program
from day6_core.session.scheduler import Scheduler
from day6_core.session.session import Session
from day6_core.session.streams import Captured


class _World:
    """A machine with the Message Publisher and a node that hears."""

    def __init__(self) -> None:
        self.scheduler = Scheduler(WorldClock(wall=None, epoch_ns=1_700_000_000 * 10**9))
        self.graph = Graph()
        self.ears = Session(self.scheduler, self.graph, ["ears"])
        self.node = self.ears.create_node("ears")
        self.ears.spawn(self.ears.spin(self.node))
        self.display = Display()
        self.output = Captured()
        session = Session(
            self.scheduler, self.graph, ["rqt_publisher"], stdout=self.output, stderr=self.output, display=self.display
        )
        self.program = Program(session, rqt_publisher.main)
        self.wait(0.2)
        self.model: Any = self.display.windows[0].model

    def wait(self, seconds: float) -> None:
        self.scheduler.advance(seconds)

    def add(self, message_class: Any, topic: str = "/topic", rate: float = 1.0, **fields: str) -> list[Any]:
        """Add a publisher with expressions; return what will be heard of it."""
        heard: list[Any] = []
        self.node.create_subscription(message_class, topic, heard.append, 1000)
        self.model.add(topic, type_name(message_class), rate)
        self.wait(0.1)
        number = self.model.shown()[-1].number
        for path, text in fields.items():
            self.model.set_expression(number, "/" + path.replace("__", "/"), text)
        self.wait(0.1)
        return heard

    def problems(self) -> dict[str, str]:
        return {row.path: row.problem for row in self.model.shown()[-1].rows if row.problem}


@pytest.fixture
def world() -> Iterator[_World]:
    found = _World()
    yield found
    found.program.interrupt()
    found.wait(0.1)
    found.ears.close()


def test_nothing_is_published_before_the_box_is_ticked_and_then_at_the_rate(world) -> None:
    heard = world.add(String, rate=5.0)
    world.wait(1.0)
    assert heard == []
    world.model.set_enabled(0, True)
    world.wait(2.05)
    assert len(heard) == 10
    world.model.set_enabled(0, False)
    world.wait(1.0)
    assert len(heard) == 10


def test_the_rate_can_be_changed_while_it_publishes(world) -> None:
    heard = world.add(String)
    world.model.set_enabled(0, True)
    world.model.set_rate(0, "20")
    world.wait(1.1)
    assert len(heard) in range(20, 23)
    world.model.set_rate(0, "0")
    world.wait(1.0)
    assert len(heard) in range(20, 23) and world.model.shown()[0].rate == 0


def test_a_message_that_takes_long_to_compute_leaves_time_to_others(world, monkeypatch) -> None:
    seconds = iter(n * 0.06 for n in range(1000))
    monkeypatch.setattr(model.time, "thread_time", lambda: next(seconds))
    heard = world.add(String, rate=20.0)
    world.model.set_enabled(0, True)
    world.wait(2.05)
    assert len(heard) in (10, 11)  # of about 40: three pass after each


@pytest.mark.parametrize("text", ["fast", "-1", "nan", "inf", "1e9", "1,5"])
def test_what_is_no_rate_is_refused_in_the_words_of_rqt(world, text: str) -> None:
    world.add(String)
    world.model.set_rate(0, text)
    world.wait(0.1)
    assert world.model.message == f"Publisher._change_publisher_rate(): could not parse rate value: {text}"
    assert world.model.shown()[0].rate == 1.0 and world.model.message in world.output.text


def test_i_counts_the_messages(world) -> None:
    heard = world.add(String, data="'Hello World: %d' % i")
    world.model.set_rate(0, "10")
    world.model.set_enabled(0, True)
    world.wait(0.35)
    world.model.publish_once(0)
    world.wait(0.1)
    assert [each.data for each in heard][:4] == [f"Hello World: {i}" for i in (1, 2, 3, 4)]


def test_one_message_is_published_by_hand(world) -> None:
    heard = world.add(Twist, linear__x="2", angular__z="pi")
    world.model.publish_once(0)
    world.wait(0.1)
    (twist,) = heard
    assert twist.linear.x == 2.0 and twist.angular.z == pytest.approx(3.1416, abs=1e-4)


def test_a_stamp_is_now(world) -> None:
    heard = world.add(PoseStamped, header__stamp="now()", header__frame_id="map")
    world.model.publish_once(0)
    world.wait(0.1)
    assert isinstance(heard[0].header.stamp, Time) and heard[0].header.stamp.sec == 1_700_000_000
    assert heard[0].header.frame_id == "map" and world.problems() == {}


def test_a_wrong_expression_is_said_in_its_line_and_the_rest_is_published(world) -> None:
    heard = world.add(Twist, linear__x="fast", linear__y="1.5", angular__z="'2'")
    assert world.problems() == {
        "/linear/x": "error evaluating as \"float\": name 'fast' is not defined",
        "/angular/z": 'error evaluating as "float"',
    }
    world.model.publish_once(0)
    world.wait(0.1)
    assert (heard[0].linear.x, heard[0].linear.y) == (0.0, 1.5)


def test_an_expression_that_fails_now_and_then_stops_nothing(world) -> None:
    heard = world.add(Int32, data="6 / (i - 2)")
    other = world.add(String, topic="/other", data="still here")
    for number in (0, 1):
        world.model.set_rate(number, "10")
        world.model.set_enabled(number, True)
    world.wait(0.36)
    assert [each.data for each in heard] == [-6, 0, 6] and len(other) == 3
    version = world.model.version
    world.wait(0.1)
    assert world.model.version == version  # nothing new to be shown


@pytest.mark.parametrize(
    ("kind", "text", "problem"),
    [
        (UInt8, "256", "unsigned integer in [0, 255]"),
        (UInt8, "-1", "unsigned integer in [0, 255]"),
        (Int32, "inf", 'error evaluating as "int"'),
        (Bool, "1", 'error evaluating as "bool"'),
        (Float64MultiArray, "3", 'error evaluating as "list"'),
        (Float64MultiArray, "['a']", 'error evaluating as "list"'),
        (Float64MultiArray, "[0] * 10 ** 9", "more than"),
        (String, "'a' * 10 ** 9", ""),
    ],
)
def test_values_that_do_not_fit_are_refused(world, kind: Any, text: str, problem: str) -> None:
    heard = world.add(kind, data=text)
    assert problem in world.problems().get("/data", "")
    world.model.publish_once(0)
    world.wait(0.1)
    assert len(heard) == 1


@pytest.mark.parametrize(
    ("kind", "text", "value"),
    [
        (Int32, "2.7", 2),
        (Bool, "i > 0", True),
        (String, "42", "42"),
        (String, "hello there", "hello there"),
        (Float64MultiArray, "[1, 2.5]", [1.0, 2.5]),
        (ByteMultiArray, "[1, 2]", [b"\x01", b"\x02"]),
    ],
)
def test_values_become_what_the_field_holds(world, kind: Any, text: str, value: object) -> None:
    heard = world.add(kind, data=text)
    world.model.publish_once(0)
    world.wait(0.1)
    found = heard[0].data
    assert (list(found) if isinstance(value, list) else found) == value


def test_publishers_are_the_nodes_and_are_gone_when_removed(world) -> None:
    world.model.add("chatter", "std_msgs/msg/String")
    world.model.add("/other", "std_msgs/msg/String")
    world.wait(0.2)
    (info,) = world.node.get_publishers_info_by_topic("/chatter")
    assert info.node_name.startswith("rqt_gui_py_node_")
    world.model.remove(0)
    world.wait(0.2)
    assert world.node.get_publishers_info_by_topic("/chatter") == [] and [
        each.number for each in world.model.shown()
    ] == [1]
    world.model.clear()
    world.wait(0.2)
    assert world.node.get_publishers_info_by_topic("/other") == [] and world.model.shown() == []
    world.model.publish_once(1)  # too late
    world.wait(0.1)


@pytest.mark.parametrize(
    ("topic", "kind", "words"),
    [
        ("/chat ter", "std_msgs/msg/String", "Invalid topic name"),
        ("/1st", "std_msgs/msg/String", "Invalid topic name"),
        ("/ok", "std_msgs/msg/Strin", "Creating message type std_msgs/msg/Strin failed."),
        ("/ok", "nowhere", "Creating message type nowhere failed."),
    ],
)
def test_a_name_or_type_that_is_none_is_refused_in_the_words_of_ros(world, topic: str, kind: str, words: str) -> None:
    world.model.add(topic, kind)
    world.wait(0.1)
    assert world.model.message.startswith(words) and world.model.shown() == [] and words in world.output.text
    world.model.add("/ok", "std_msgs/msg/String")
    world.wait(0.1)
    assert world.model.message == ""


def test_a_perspective_keeps_the_publishers_as_rqt_writes_them(world) -> None:
    world.add(Twist, "/turtle1/cmd_vel", 2.5, linear__x="sin(i)")
    world.model.set_enabled(0, True)
    world.wait(0.1)
    text = world.model.kept()
    (kept,) = ast.literal_eval(text)
    assert kept["topic_name"] == "/turtle1/cmd_vel" and kept["enabled"] is False
    assert kept["expressions"] == {"/turtle1/cmd_vel/linear/x": "sin(i)"}
    place = PluginPlace(world.ears, world.node, settings={"publishers": text})
    plugin = rqt_publisher.PublisherPlugin(place)
    (shown,) = plugin.model.shown()
    assert (shown.topic, shown.rate, shown.enabled) == ("/turtle1/cmd_vel", 2.5, False)
    assert {row.path: row.text for row in shown.rows}["/linear/x"] == "sin(i)"
    plugin.close()
    assert "ears" not in [each.node_name for each in world.node.get_publishers_info_by_topic("/turtle1/cmd_vel")]


@pytest.mark.parametrize(
    "kept",
    [
        5,
        None,
        "",
        "[",
        "__import__('os').system('true')",
        "(" * 10_000,
        "[5, None, {}, {'topic_name': 'x'}]",
        "[{'topic_name': '/x', 'type_name': 'std_msgs/msg/String', 'rate': -5, 'expressions': {'/x/no': '1', 5: 6}}]",
        "[{'topic_name': ' ', 'type_name': 'std_msgs/msg/String', 'rate': 1}]",
        "[{'topic_name': '/x', 'type_name': 'std_msgs/msg/String', 'rate': 1, 'expressions': {'/x/data/deep[3]': '1'}}]",
    ],
)
def test_a_perspective_may_be_anything(world, kept: object) -> None:
    plugin = rqt_publisher.PublisherPlugin(PluginPlace(world.ears, world.node, settings={"publishers": kept}))
    assert all(each.rate == 1.0 for each in plugin.model.shown())
    plugin.close()


def test_the_topics_there_are_can_be_chosen(world) -> None:
    world.node.create_publisher(Twist, "cmd_vel", 10)
    assert ("/cmd_vel", "geometry_msgs/msg/Twist") in world.model.topics()


def test_a_wrong_expression_leaves_the_one_before_in_force(world) -> None:
    heard = world.add(Twist, linear__x="2 * i")
    world.model.set_expression(0, "/linear/x", "2 * j")
    world.wait(0.1)
    (row,) = (row for row in world.model.shown()[0].rows if row.path == "/linear/x")
    assert (row.text, row.in_force) == ("2 * j", "2 * i") and "'j' is not defined" in row.problem
    for _ in range(2):
        world.model.publish_once(0)
    world.wait(0.1)
    assert [each.linear.x for each in heard] == [2.0, 4.0]
    assert "2 * j" not in world.model.kept() and "2 * i" in world.model.kept()
    world.model.set_expression(0, "/linear/x", "3")
    world.wait(0.1)
    assert world.problems() == {}


def test_the_elements_of_an_array_have_expressions_of_their_own(world) -> None:
    heard = world.add(PoseWithCovariance)
    world.model.set_expression(0, "/covariance[35]", "i / 10")
    world.model.set_expression(0, "/covariance[0]", "300")
    world.model.publish_once(0)
    world.wait(0.1)
    assert (heard[0].covariance[0], heard[0].covariance[1], heard[0].covariance[35]) == (300.0, 0.0, 0.1)


def test_a_list_grows_and_shrinks_and_its_elements_are_filled_in(world) -> None:
    heard = world.add(Polygon)
    for _ in range(3):
        world.model.resize(0, "/points", 1)
    world.model.resize(0, "/points", -1)
    world.model.set_expression(0, "/points[1]/x", "sin(i)")
    world.wait(0.1)
    assert [row.path for row in world.model.shown()[0].rows if row.is_branch] == ["/points", "/points[0]", "/points[1]"]
    world.model.publish_once(0)
    world.wait(0.1)
    assert [point.x for point in heard[0].points] == pytest.approx([0.0, 0.8415], abs=1e-4)
    again = _World()
    again.model.post(lambda: again.model.take_kept(world.model.kept()))
    again.wait(0.1)
    texts = {row.path: row.text for row in again.model.shown()[0].rows}
    assert texts["/points[1]/x"] == "sin(i)"
    again.program.interrupt()


def test_a_bounded_list_grows_to_its_bound_and_says_so(world) -> None:
    world.add(BoundedSequences)
    for _ in range(4):
        world.model.resize(0, "/int32_values", 1)
        world.wait(0.1)
    rows = [row.path for row in world.model.shown()[0].rows if row.path.startswith("/int32_values[")]
    assert len(rows) == 3 and "/int32_values" in world.problems()


def test_an_element_out_of_range_is_refused(world) -> None:
    heard = world.add(ByteMultiArray)
    world.model.resize(0, "/data", 1)
    world.model.set_expression(0, "/data[0]", "256")
    world.wait(0.1)
    assert world.problems().keys() == {"/data[0]"}
    world.model.publish_once(0)
    world.wait(0.1)
    assert list(heard[0].data) == [b"\x00"]
