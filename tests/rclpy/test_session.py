"""Contexts inside day6-tui: on a given graph, by a given clock, with logging of their own."""

from __future__ import annotations

import signal
from typing import Any

from rosgraph_msgs.msg import Clock
from std_msgs.msg import String

import rclpy
from day6_core.graph import Graph
from rclpy.clock_type import ClockType
from rclpy.context import Context
from rclpy.parameter import Parameter

EPOCH_NS = 1_700_000_000_000_000_000
SECOND = 1_000_000_000


def test_clocks_and_log_stamps_read_the_session_clock(world: Any) -> None:
    node = world.node("n")
    world.time.elapsed = 1_500_000_000
    assert node.get_clock().now().nanoseconds == EPOCH_NS + 1_500_000_000
    node.get_logger().info("hello")
    assert world.log == ["[INFO] [1700000001.500000000] [n]: hello\n"]


def test_a_session_touches_neither_signals_nor_the_default_context(world: Any) -> None:
    before = signal.getsignal(signal.SIGINT), signal.getsignal(signal.SIGTERM)
    world.node("n")
    assert (signal.getsignal(signal.SIGINT), signal.getsignal(signal.SIGTERM)) == before
    assert not rclpy.ok()


def test_log_levels_of_one_session_are_not_those_of_another(world: Any) -> None:
    other = Context._for_session(Graph(), world.time, ["prog", "--ros-args", "--log-level", "debug"], env={})
    lines: list[str] = []
    other._log_write = lines.append
    node = rclpy.create_node("loud", context=other)
    quiet = world.node("quiet")
    node.get_logger().debug("seen")
    quiet.get_logger().debug("not seen")
    assert len(lines) == 1 and world.log == []
    other.shutdown()


def test_two_contexts_of_one_graph_see_each_other_and_end_alone(world: Any) -> None:
    other = Context._for_session(world.graph, world.time, env={})
    talker = rclpy.create_node("talker", context=other)
    listener = world.node("listener")
    heard: list[str] = []
    listener.create_subscription(String, "chatter", lambda m: heard.append(m.data), 10)
    talker.create_publisher(String, "chatter", 10).publish(String(data="hi"))
    world.settle()
    assert heard == ["hi"]
    other.shutdown()
    assert listener.get_node_names() == ["listener"]


def test_session_arguments_remap_and_set_parameters(world: Any) -> None:
    args = ["prog", "--ros-args", "-r", "__node:=bob", "-r", "chatter:=news", "-p", "speed:=3"]
    context = Context._for_session(Graph(), world.time, args, env={})
    node = rclpy.create_node("talker", context=context)
    assert node.get_fully_qualified_name() == "/bob"
    assert node.resolve_topic_name("chatter") == "/news"
    assert node.declare_parameter("speed", 1).value == 3
    context.shutdown()


def test_simulated_time_drives_the_timers_of_a_node_that_uses_it(world: Any) -> None:
    node = world.node("n", parameter_overrides=[Parameter("use_sim_time", value=True)])
    clock = node.create_publisher(Clock, "/clock", 10)
    ticks: list[int] = []
    node.create_timer(1.0, lambda: ticks.append(node.get_clock().now().nanoseconds // SECOND))

    def tell(seconds: int) -> None:
        message = Clock()
        message.clock.sec = seconds
        clock.publish(message)
        world.settle()

    world.run(5.0)
    assert ticks == [], "world time alone does not drive it"
    for seconds in (10, 11, 12, 20):
        tell(seconds)
    assert ticks == [10, 11, 12, 20], "calls missed in a leap are left out"
    assert node.get_clock().now().clock_type is ClockType.ROS_TIME
    tell(5)
    tell(6)
    assert ticks[4:] == [6], "after a jump back a whole period has to pass"
