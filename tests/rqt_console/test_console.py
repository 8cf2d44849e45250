"""The console's messages and what it leaves out; its window in the desktop of the tests."""

from __future__ import annotations

from types import SimpleNamespace

import pytest
from turtlesim.srv import TeleportAbsolute

from day6_core.ros.programs.rqt_console import model
from day6_core.ros.programs.rqt_console.filters import Filter
from day6_core.ros.programs.rqt_console.model import Console
from tests.support.stepped_machine import SteppedMachine


def log(text="hello", level=20, node="talker", second=5):
    return SimpleNamespace(
        stamp=SimpleNamespace(sec=second, nanosec=250_000_000),
        level=level,
        name=node,
        msg=text,
        file="talker.py",
        function="tick",
        line=7,
    )


def texts(console):
    return [record.text for record in console.shown()]


def test_every_message_has_a_number_a_severity_and_a_place():
    console = Console()
    console.receive(log(level=30))
    (record,) = console.shown()
    assert (record.number, record.severity, record.node) == (1, "Warn", "talker")
    assert (record.stamp_ns, record.location) == (5_250_000_000, "talker.py:tick:7")


def test_severities_texts_and_nodes_can_be_left_out_and_come_back():
    console = Console()
    for text, level, node in (("one", 10, "a"), ("two", 20, "a"), ("Three", 30, "b"), ("four", 50, "b")):
        console.receive(log(text, level, node))
    console.toggle_level(10)
    assert texts(console) == ["two", "Three", "four"]
    console.set_filter("excludes", 1, Filter("message", "Three"))
    assert texts(console) == ["two", "four"]
    console.toggle_node("b")
    console.receive(log("five", 20, "b"))
    console.receive(log("six", 20, "a"))
    assert texts(console) == ["two", "six"] and console.total == 6
    console.toggle_node("b")
    console.set_filter("excludes", 1, None)
    console.toggle_level(10)
    assert texts(console) == ["one", "two", "Three", "four", "five", "six"]
    console.toggle_level(50)
    console.show_everything()
    assert len(console.shown()) == 6


def test_highlighting_leaves_nothing_out():
    console = Console()
    console.receive(log("Oh no! I hit the wall!"))
    console.set_filter("highlights", 0, Filter("message", "wall"))
    (record,) = console.shown()
    assert console.choice.is_highlighted(record)
    console.set_filter("highlights", 0, None)
    assert not console.choice.is_highlighted(record)


def test_what_comes_while_paused_is_not_kept_and_clear_forgets():
    console = Console()
    console.receive(log("before"))
    console.toggle_paused()
    console.receive(log("meanwhile"))
    console.toggle_paused()
    console.receive(log("after"))
    assert texts(console) == ["before", "after"]
    console.clear()
    assert texts(console) == [] and console.total == 0
    console.receive(log("again"))
    assert [record.number for record in console.shown()] == [3]


def test_old_messages_are_forgotten_when_there_are_too_many(monkeypatch):
    monkeypatch.setattr(model, "MOST", 10)
    console = Console()
    for number in range(95):
        console.receive(log(str(number)))
        assert len(console.shown()) <= 10
    assert texts(console) == [str(number) for number in range(85, 95)] and console.total == 10


@pytest.fixture
def machine():
    made = SteppedMachine()
    yield made
    made.end()


def test_the_tutorial_a_turtle_that_hits_the_wall_is_in_the_console(machine):
    machine.start("turtlesim", "turtlesim_node")
    machine.start("rqt_console", "rqt_console", screen=True)
    from geometry_msgs.msg import Twist

    console = machine.display.windows[0].model
    publisher = machine.node.create_publisher(Twist, "/turtle1/cmd_vel", 10)
    machine.call(TeleportAbsolute, "/turtle1/teleport_absolute", x=11.0, y=5.5, theta=0.0)
    twist = Twist()
    twist.linear.x = 2.0
    publisher.publish(twist)
    machine.advance(0.5)
    walls = [record for record in console.shown() if "Oh no! I hit the wall!" in record.text]
    assert walls and {(record.severity, record.node) for record in walls} == {("Warn", "turtlesim")}
    console.toggle_level(30)
    assert not any("wall" in text for text in texts(console))


def test_without_a_screen_the_messages_are_printed(machine):
    running = machine.start("rqt_console", "rqt_console")
    machine.node.get_logger().warning("look out")
    machine.advance(0.1)
    assert running.output == "#1 Warn [watcher]: look out\n"


def test_what_was_logged_just_before_is_heard_as_in_the_real_one(machine):
    machine.start("turtlesim", "turtlesim_node")
    machine.advance(0.5)
    machine.start("rqt_console", "rqt_console", screen=True)
    machine.advance(0.1)
    assert "Starting turtlesim with node name /turtlesim" in texts(machine.display.windows[0].model)
