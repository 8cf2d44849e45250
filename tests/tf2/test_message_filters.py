"""message_filters: what goes together, and what is dropped."""

from __future__ import annotations

import pytest
from message_filters import ApproximateTimeSynchronizer, Cache, SimpleFilter, Subscriber, TimeSynchronizer
from sensor_msgs.msg import Image, LaserScan
from std_msgs.msg import String

import rclpy
from rclpy.clock_type import ClockType
from rclpy.node import Node
from rclpy.time import Time
from tests.support.waiting import until


def scan(seconds: float) -> LaserScan:
    message = LaserScan()
    message.header.stamp = Time(nanoseconds=round(seconds * 1e9)).to_msg()
    return message


def stamps(messages: tuple[LaserScan, ...]) -> tuple[float, ...]:
    return tuple(round(each.header.stamp.sec + each.header.stamp.nanosec * 1e-9, 6) for each in messages)


class Pair:
    """Two filters under a synchronizer, and what it let through."""

    def __init__(self, slop: float | None = None, queue_size: int = 10) -> None:
        self.filters = [SimpleFilter(), SimpleFilter()]
        self.sync = (
            TimeSynchronizer(self.filters, queue_size)
            if slop is None
            else ApproximateTimeSynchronizer(self.filters, queue_size, slop)
        )
        self.seen: list[tuple[float, ...]] = []
        self.sync.registerCallback(lambda *messages: self.seen.append(stamps(messages)))

    def feed(self, which: int, *seconds: float) -> None:
        for each in seconds:
            self.filters[which].signalMessage(scan(each))


def test_equal_times_go_together_whatever_their_order() -> None:
    pair = Pair()
    pair.feed(0, 1, 2, 3)
    pair.feed(1, 3, 1, 4)
    assert pair.seen == [(3, 3), (1, 1)]


def test_a_full_queue_forgets_the_oldest() -> None:
    pair = Pair(queue_size=2)
    pair.feed(0, 1, 2, 3)
    pair.feed(1, 1, 2)
    assert pair.seen == [(2, 2)]


def test_near_times_go_together_and_the_nearest_wins() -> None:
    pair = Pair(slop=0.1)
    pair.feed(0, 1.0, 1.05, 2.0)
    pair.feed(1, 1.04)
    assert pair.seen == [(1.05, 1.04)]
    pair.feed(1, 2.2)
    assert pair.seen == [(1.05, 1.04)]
    pair.feed(1, 1.95)
    assert pair.seen[1:] == [(2.0, 1.95)]


def test_exactly_the_slop_is_too_far() -> None:
    pair = Pair(slop=0.5)
    pair.feed(0, 1.0)
    pair.feed(1, 1.5)
    assert pair.seen == []
    pair.feed(1, 1.25)
    assert pair.seen == [(1.0, 1.25)]


def test_callbacks_get_the_arguments_they_were_registered_with() -> None:
    source = SimpleFilter()
    seen: list[tuple[object, ...]] = []
    assert source.registerCallback(lambda *args: seen.append(args), "more", 5) == 0
    source.signalMessage("message")
    assert seen == [("message", "more", 5)]


def test_a_message_without_a_header_needs_permission(capfd: pytest.CaptureFixture[str]) -> None:
    source = SimpleFilter()
    cache = Cache(source)
    source.signalMessage(String())
    assert cache.getLast() is None
    assert "[message_filters_cache]: can not use message filters messages without timestamp" in capfd.readouterr().err
    generous = Cache(source, allow_headerless=True)
    source.signalMessage(String(data="x"))
    assert generous.getLast() == String(data="x")


def test_a_cache_answers_questions_about_times() -> None:
    source = SimpleFilter()
    cache = Cache(source, cache_size=3)
    passed: list[LaserScan] = []
    cache.registerCallback(passed.append)
    for second in (1, 2, 3, 4):
        source.signalMessage(scan(second))
    at = [Time(seconds=second, clock_type=ClockType.ROS_TIME) for second in range(6)]
    assert stamps(tuple(cache.getInterval(at[1], at[3]))) == (2, 3)
    assert stamps((cache.getElemAfterTime(at[3]), cache.getElemBeforeTime(at[3]), cache.getLast())) == (3, 3, 4)
    assert cache.getElemAfterTime(at[5]) is None and cache.getElemBeforeTime(at[1]) is None
    assert (cache.getOldestTime(), cache.getLastestTime()) == (at[2], at[4])
    assert len(passed) == 4


def test_subscribers_bring_topics_together(node: Node) -> None:
    camera = Subscriber(node, Image, "camera", qos_profile=5)
    laser = Subscriber(node, LaserScan, "laser")
    seen: list[tuple[Image, LaserScan]] = []
    sync = ApproximateTimeSynchronizer([camera, laser], queue_size=5, slop=0.1)
    sync.registerCallback(lambda *messages: seen.append(messages))
    assert (laser.getTopic(), laser.topic_name) == ("laser", "/laser")
    images, scans = node.create_publisher(Image, "camera", 5), node.create_publisher(LaserScan, "laser", 5)
    image = Image()
    image.header = scan(1.02).header
    images.publish(image)
    scans.publish(scan(1.0))
    until(lambda: seen, meanwhile=lambda: rclpy.spin_once(node, timeout_sec=0.05))
    assert (type(seen[0][0]), type(seen[0][1])) == (Image, LaserScan)
