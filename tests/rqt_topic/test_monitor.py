"""The topic monitor's numbers and lists, on a clock that the test moves."""

from __future__ import annotations

import threading
from collections.abc import Callable, Iterator
from typing import Any

import pytest
from std_msgs.msg import String

from day6_core.graph import Graph
from day6_core.ros.programs.rqt_gui.plugin import PluginPlace
from day6_core.ros.programs.rqt_topic import rqt_topic
from day6_core.ros.programs.rqt_topic._measure import SECOND, Measure
from day6_core.session.clock import WorldClock
from day6_core.session.display import Display
from day6_core.session.program import Program
from day6_core.session.scheduler import Scheduler
from day6_core.session.session import Session
from day6_core.session.streams import Captured


def test_fifty_messages_a_second_are_fifty_hertz() -> None:
    measure = Measure()
    for n in range(100):
        measure.add(n * SECOND // 50, 24)
    rate, bandwidth = measure.rates(99 * SECOND // 50)
    assert rate == pytest.approx(50.0)
    assert bandwidth == pytest.approx(1200, rel=0.02)


def test_nothing_is_measured_from_one_message() -> None:
    measure = Measure()
    measure.add(0, 100)
    assert measure.rates(SECOND) is None


def test_a_topic_that_falls_silent_gets_slower_and_then_has_no_rate() -> None:
    measure = Measure()
    for n in range(20):
        measure.add(n * SECOND // 10, 8)
    last = 19 * SECOND // 10
    rates = [measure.rates(last + gap * SECOND) for gap in (0, 1, 2, 3, 6)]
    assert rates[0][0] == pytest.approx(10.0)
    values = [rate[0] for rate in rates[:4]]
    assert values == sorted(values, reverse=True) and values[1] < 8
    assert rates[4] is None


def test_the_sparkline_has_one_bar_for_every_look() -> None:
    measure = Measure()
    measure.tick(0)
    for n in range(10):
        measure.add(n, 1)
    measure.tick(SECOND // 2)
    measure.tick(SECOND)
    assert measure.bars == (20.0, 0.0)


class _World:
    """A machine with the monitor and a node that publishes."""

    def __init__(self) -> None:
        self.clock = WorldClock(wall=None, epoch_ns=1_700_000_000 * SECOND)
        self.scheduler = Scheduler(self.clock)
        self.graph = Graph()
        self.display = Display()
        self.talker = Session(self.scheduler, self.graph, ["talker"])
        self.node = self.talker.create_node("talker")

    def start(self, display: Display | None) -> tuple[Program, Captured]:
        output = Captured()
        session = Session(self.scheduler, self.graph, ["rqt_topic"], stdout=output, stderr=output, display=display)
        program = Program(session, rqt_topic.main)
        self.scheduler.advance(0.2)
        return program, output


@pytest.fixture
def world() -> Iterator[_World]:
    found = _World()
    yield found
    found.talker.close()


def _topic(model: Any, name: str) -> Any:
    return next(topic for topic in model.topics if topic.name == name)


def test_the_window_lists_topics_with_who_speaks_and_who_hears(world) -> None:
    world.node.create_publisher(String, "chatter", 10)
    world.node.create_subscription(String, "chatter", lambda message: None, 5)
    program, _ = world.start(world.display)
    model = world.display.windows[0].model
    topic = _topic(model, "/chatter")
    assert topic.types == ("std_msgs/msg/String",)
    assert [end.node for end in topic.publishers] == ["/talker"]
    assert [end.node for end in topic.subscriptions] == ["/talker"]
    assert topic.publishers[0].qos.startswith("RELIABLE VOLATILE")
    assert not topic.monitored and topic.rate is None
    program.interrupt()
    world.scheduler.advance(0.1)
    assert program.status is not None and world.display.windows == []


def test_a_ticked_topic_is_listened_to_and_measured(world) -> None:
    publisher = world.node.create_publisher(String, "chatter", 10)
    world.start(world.display)
    model = world.display.windows[0].model
    model.toggle("/chatter")
    world.scheduler.advance(0.2)
    (ear,) = _topic(model, "/chatter").subscriptions
    assert ear.node.startswith("/rqt_gui_py_node_")
    _publish(world, publisher, lambda n: f"Hello {n}", hertz=20, seconds=3)
    topic = _topic(model, "/chatter")
    assert topic.rate == pytest.approx(20, rel=0.05)
    assert topic.bandwidth == pytest.approx(20 * 17, rel=0.15)
    assert max(topic.bars) == pytest.approx(20, rel=0.15)
    assert model.last_message("/chatter").data == "Hello 59"
    model.toggle("/chatter")
    world.scheduler.advance(0.2)
    assert _topic(model, "/chatter").subscriptions == () and not _topic(model, "/chatter").monitored


def _publish(world: _World, publisher: Any, text: Callable[[int], str], *, hertz: int, seconds: int) -> None:
    for n in range(hertz * seconds):
        publisher.publish(String(data=text(n)))
        world.scheduler.advance(1 / hertz)


def test_the_topics_of_a_kept_perspective_are_listened_to_as_soon_as_they_are_there(world) -> None:
    session = Session(world.scheduler, world.graph, ["rqt"], display=world.display)
    node = session.create_node("rqt_gui_py_node_1")
    plugin = rqt_topic.TopicMonitorPlugin(
        PluginPlace(session, node, settings={"selected_topics": ["/late", 7, "/never"]})
    )
    model = plugin.model
    assert plugin.settings() == {"selected_topics": ["/late", "/never"]}
    world.node.create_publisher(String, "late", 10)
    model.refresh()
    model.refresh()
    assert _topic(model, "/late").monitored
    assert plugin.settings() == {"selected_topics": ["/late", "/never"]}
    plugin.close()
    model.refresh()
    assert _topic(model, "/late").subscriptions == ()
    session.close()


def test_messages_are_counted_without_waking_the_program(world) -> None:
    publisher = world.node.create_publisher(String, "chatter", 10)
    world.start(world.display)
    model = world.display.windows[0].model
    model.toggle("/chatter")
    world.scheduler.advance(0.2)
    for _ in range(100):  # far more than the queue of a subscription holds
        publisher.publish(String(data="x"))
    assert model.last_message("/chatter").data == "x"
    world.scheduler.advance(1.0)
    assert _topic(model, "/chatter").count == 100


def test_what_came_from_two_threads_is_all_counted() -> None:
    measure = Measure()

    def add() -> None:
        for number in range(20_000):
            measure.add(number, 1)

    threads = [threading.Thread(target=add) for _ in range(2)]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join()
    assert measure.count == 40_000


def test_the_feedback_of_an_action_and_the_events_of_a_service_are_listened_to(world) -> None:
    from example_interfaces.action import Fibonacci
    from std_srvs.srv import SetBool

    from rclpy.action import ActionServer

    ActionServer(world.node, Fibonacci, "fibonacci", lambda goal: Fibonacci.Result())
    feedback = world.node.create_publisher(Fibonacci.Impl.FeedbackMessage, "fibonacci/_action/feedback", 1)
    events = world.node.create_publisher(SetBool.Event, "switch/_service_event", 1)
    world.start(world.display)
    model = world.display.windows[0].model
    for topic, publisher in (("/fibonacci/_action/feedback", feedback), ("/switch/_service_event", events)):
        model.toggle(topic)
        world.scheduler.advance(0.2)
        assert _topic(model, topic).problem == "" and _topic(model, topic).monitored
        publisher.publish(publisher.msg_type())
        assert model.last_message(topic) == publisher.msg_type()


def test_topics_that_come_later_appear_by_themselves(world) -> None:
    world.start(world.display)
    model = world.display.windows[0].model
    before = model.version
    world.node.create_publisher(String, "late", 10)
    world.scheduler.advance(0.5)
    assert _topic(model, "/late") and model.version > before


def test_a_type_nobody_here_knows_is_told_in_the_window(world) -> None:
    world.start(world.display)
    model = world.display.windows[0].model
    model.topics = (*model.topics, _unknown(model))
    model._toggled.append("/strange")
    model._listen("/strange")
    assert "strange_msgs" in model._problems["/strange"]


def _unknown(model: Any) -> Any:
    from day6_core.ros.programs.rqt_topic.model import Topic

    return Topic("/strange", ("strange_msgs/msg/Thing",), (), ())


def test_without_a_screen_the_topics_are_printed(world) -> None:
    world.node.create_publisher(String, "chatter", 10)
    program, output = world.start(None)
    world.scheduler.advance(1.0)
    assert program.status == 0
    assert "/chatter [std_msgs/msg/String]" in output.text.splitlines()
