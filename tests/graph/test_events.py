"""Deadlines and liveliness as Fast DDS counts them, by a clock that only moves when a test steps it."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import pytest

from day6_core.graph import Graph
from day6_core.graph.endpoints import Publisher, Subscription
from day6_core.graph.events import EventKind
from day6_core.graph.node import Node
from day6_core.graph.qos import Liveliness, QoS

MANUAL = QoS(liveliness=Liveliness.MANUAL_BY_TOPIC, liveliness_lease_duration=100)


class Time:
    """Stepped nanoseconds."""

    def __init__(self) -> None:
        self.now = 1_000_000

    def __call__(self) -> int:
        return self.now


@pytest.fixture
def time() -> Time:
    return Time()


@pytest.fixture
def node(time: Time) -> Node:
    graph = Graph()
    graph.now_ns = time
    return graph.create_node("n")


def publisher(node: Node, qos: QoS) -> Publisher:
    return node.create_publisher("/t", "std_msgs/msg/String", "", qos, lambda message: message)


def subscription(node: Node, qos: QoS) -> Subscription:
    return node.create_subscription("/t", "std_msgs/msg/String", "", qos)


def remote(node: Node, qos: QoS) -> Publisher:
    return publisher(node.graph.create_node("far", origin="elsewhere"), qos)


def test_a_deadline_counts_from_the_first_message_on(node: Node, time: Time) -> None:
    qos = QoS(deadline=100)
    pub, sub = publisher(node, qos), subscription(node, qos)
    time.now += 1000
    assert pub.status(EventKind.DEADLINE_MISSED).total_count == 0
    assert pub.due(EventKind.DEADLINE_MISSED) is None
    pub.publish("x")
    for endpoint in (pub, sub):
        assert endpoint.due(EventKind.DEADLINE_MISSED) == time.now + 100
    time.now += 350
    for endpoint in (pub, sub):
        taken = endpoint.take_event(EventKind.DEADLINE_MISSED)
        assert (taken.total_count, taken.total_count_change) == (3, 3)
        assert endpoint.due(EventKind.DEADLINE_MISSED) == time.now + 50


def test_a_message_starts_the_period_anew(node: Node, time: Time) -> None:
    qos = QoS(deadline=100)
    pub, sub = publisher(node, qos), subscription(node, qos)
    for _ in range(5):
        pub.publish("x")
        time.now += 99
    assert sub.status(EventKind.DEADLINE_MISSED).total_count == 0
    time.now += 1
    assert sub.status(EventKind.DEADLINE_MISSED).total_count == 1


def test_the_first_message_tells_that_there_is_something_to_wait_for(node: Node, time: Time) -> None:
    told: list[EventKind] = []
    sub = subscription(node, QoS(deadline=100))
    sub.on_event = lambda _, kind: told.append(kind)
    pub = publisher(node, QoS(deadline=100))
    told.clear()
    pub.publish("x")
    pub.publish("x")
    assert told == [EventKind.DEADLINE_MISSED]


def test_a_manual_publisher_lives_from_its_first_assertion_until_the_lease_is_over(node: Node, time: Time) -> None:
    pub, sub = publisher(node, MANUAL), subscription(node, MANUAL)
    time.now += 500
    assert alive(sub) == (0, 0), "it was never alive, so it is not dead either"
    pub.assert_liveliness()
    assert alive(sub) == (1, 0)
    time.now += 100
    assert alive(sub) == (0, 1)
    assert pub.status(EventKind.LIVELINESS_LOST).total_count == 1
    pub.publish("x")
    assert alive(sub) == (1, 0), "a message is a sign of life, too"
    pub.destroy()
    assert alive(sub) == (0, 0)


def test_the_subscription_goes_by_its_own_lease(node: Node, time: Time) -> None:
    pub = publisher(node, MANUAL)
    patient = subscription(node, QoS(liveliness_lease_duration=150))
    careless = subscription(node, QoS())
    pub.assert_liveliness()
    time.now += 120
    assert pub.status(EventKind.LIVELINESS_LOST).total_count == 1
    assert alive(patient) == (1, 0)
    time.now += 30
    assert alive(patient) == (0, 1)
    assert alive(careless) == (0, 0)
    assert careless.due(EventKind.LIVELINESS_CHANGED) is None


def test_a_dead_publisher_that_goes_is_no_longer_counted(node: Node, time: Time) -> None:
    pub, sub = publisher(node, MANUAL), subscription(node, MANUAL)
    pub.assert_liveliness()
    time.now += 200
    assert alive(sub) == (0, 1)
    pub.destroy()
    assert alive(sub) == (0, 0)


def test_an_automatic_publisher_of_another_process_lives_as_long_as_it_exists(node: Node, time: Time) -> None:
    qos = QoS(liveliness_lease_duration=100)
    sub = subscription(node, qos)
    far = remote(node, qos)
    assert alive(sub) == (1, 0)
    time.now += 10_000
    assert alive(sub) == (1, 0)
    assert sub.due(EventKind.LIVELINESS_CHANGED) is None
    far.destroy()
    assert alive(sub) == (0, 0)


def test_a_content_filter_keeps_messages_out_before_they_are_queued(node: Node) -> None:
    sub, pub = subscription(node, QoS(depth=1)), publisher(node, QoS())
    wanted: Callable[[Any], bool] = "yes".__eq__
    sub.filter_by(wanted)
    for message in ("yes", "no"):
        pub.publish(message)
    assert [sample[0] for sample in sub.queue] == ["yes"]
    sub.filter_by(None)
    pub.publish("no")
    assert [sample[0] for sample in sub.queue] == ["no"]


def test_without_deadline_and_lease_nothing_is_watched(node: Node) -> None:
    for endpoint in (publisher(node, QoS()), subscription(node, QoS())):
        assert not endpoint.watches


def alive(sub: Subscription) -> tuple[int, int]:
    status = sub.status(EventKind.LIVELINESS_CHANGED)
    return status.current_count, status.not_alive_count
