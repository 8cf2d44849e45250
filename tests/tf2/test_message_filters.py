"""message_filters: what goes together, and what is dropped."""

from __future__ import annotations

import pytest
from message_filters import (
    ApproximateTimeSynchronizer,
    Cache,
    Chain,
    DeltaFilter,
    InputAligner,
    PathDeltaFilter,
    QueueStatus,
    SimpleFilter,
    Subscriber,
    TimeSequencer,
    TimeSynchronizer,
)
from sensor_msgs.msg import Image, LaserScan
from std_msgs.msg import String

import rclpy
from rclpy.clock_type import ClockType
from rclpy.duration import Duration
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


def test_equal_times_go_together_and_what_is_older_is_forgotten() -> None:
    pair = Pair()
    pair.feed(0, 1, 2, 3, 5, 4)
    pair.feed(1, 2, 1, 3, 4, 5)
    assert pair.seen == [(2, 2), (3, 3), (4, 4), (5, 5)]
    assert [list(queue) for queue in pair.sync.queues] == [[], []]


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


def test_an_offset_is_taken_off_the_times_of_its_filter() -> None:
    filters = [SimpleFilter(), SimpleFilter()]
    seen: list[tuple[float, ...]] = []
    sync = ApproximateTimeSynchronizer(filters, 10, 0.1, queue_offset=[0, 2_000_000_000])
    sync.registerCallback(lambda *messages: seen.append(stamps(messages)))
    for second in (1, 3):
        filters[0].signalMessage(scan(second))
        filters[1].signalMessage(scan(second + 0.05))
    assert seen == [(1, 3.05)]


def test_the_arrival_or_a_getter_of_ones_own_can_be_the_time() -> None:
    for more in ({"sync_arrival_time": True}, {"time_getter": lambda message: Time(seconds=len(message.data))}):
        filters = [SimpleFilter(), SimpleFilter()]
        seen: list[tuple[str, str]] = []
        sync = ApproximateTimeSynchronizer(filters, 10, 60.0, **more)
        sync.registerCallback(lambda one, two, seen=seen: seen.append((one.data, two.data)))
        filters[0].signalMessage(String(data="a"))
        filters[1].signalMessage(String(data="ab"))
        assert seen == [("a", "ab")], more


def test_a_chain_passes_through_its_filters_one_after_another() -> None:
    source, seen = SimpleFilter(), []
    chain = Chain(source)
    chain.registerCallback(lambda message: seen.append(message.data))
    source.signalMessage(String(data="none"))
    chain.addFilter(PathDeltaFilter(["data"]))
    chain.addFilter(PathDeltaFilter(["data"]))
    for text in ("a", "a", "b"):
        source.signalMessage(String(data=text))
    assert seen == ["none", "a", "b"]
    assert chain.getFilter(0) is not chain.getFilter(1)
    with pytest.raises(RuntimeError, match="Already connected"):
        chain.connectInput(source)


def test_a_delta_filter_passes_what_has_changed() -> None:
    source, seen = SimpleFilter(), []
    DeltaFilter([lambda each: each.range_min, lambda each: each.range_max], source).registerCallback(seen.append)
    sent = [LaserScan(range_min=low, range_max=high) for low, high in ((0.0, 0.0), (0.0, 0.0), (0.0, 1.0), (2.0, 1.0))]
    for message in sent:
        source.signalMessage(message)
    assert seen == [sent[0], sent[2], sent[3]]
    wrong = PathDeltaFilter(["header.nothing"])
    wrong.add(sent[0])
    with pytest.raises(
        RuntimeError, match=r"Unable to access field 'nothing' of Header \(full path: 'header.nothing'\)"
    ):
        wrong.add(sent[0])
    whole = DeltaFilter([lambda each: each.header])
    whole.add(sent[0])
    with pytest.raises(TypeError, match="Unable to compare fields of types"):
        whole.add(sent[0])


def test_an_input_aligner_waits_for_the_other_input_as_long_as_it_may_be_late() -> None:
    inputs, seen = [SimpleFilter(), SimpleFilter()], []
    aligner = InputAligner(Duration(seconds=2), *inputs)
    for number in (0, 1):
        aligner.setInputPeriod(number, Duration(seconds=1))
        aligner.registerCallback(number, lambda message, who: seen.append((who, *stamps((message,)))), "ab"[number])
    inputs[1].signalMessage(scan(1))
    inputs[0].signalMessage(scan(2))
    inputs[0].signalMessage(scan(3))
    aligner.dispatchMessages()
    assert seen == [("b", 1), ("a", 2)]  # then the second input is expected at 2
    inputs[1].signalMessage(scan(1.5))
    assert aligner.getQueueStatus(1) == QueueStatus(True, 0, 1, 1)
    inputs[0].signalMessage(scan(4))
    aligner.dispatchMessages()
    assert seen[2:] == [("a", 3), ("a", 4)] and not aligner.getQueueStatus(1).active


def test_a_sequencer_holds_messages_back_and_sorts_them(node: Node) -> None:
    source, seen = SimpleFilter(), []
    sequencer = TimeSequencer(source, 0.0, 0.01, 3, node)
    sequencer.registerCallback(lambda message: seen.append(stamps((message,))[0]))
    for second in (3, 1, 2, 4):
        source.signalMessage(scan(second))
    until(lambda: seen, meanwhile=lambda: rclpy.spin_once(node, timeout_sec=0.05))
    source.signalMessage(scan(3))
    source.signalMessage(scan(5))
    until(lambda: len(seen) > 3, meanwhile=lambda: rclpy.spin_once(node, timeout_sec=0.05))
    assert seen == [2, 3, 4, 5]
    sequencer.shutdown()
