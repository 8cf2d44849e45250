"""What two threads do to the graph at once, with Python changing threads every microsecond."""

from __future__ import annotations

import sys
import threading
from collections.abc import Callable, Iterator
from typing import Any

import pytest

from day6_core.graph import Graph, QoS
from day6_core.graph.endpoints import EventKind, Subscription
from day6_core.graph.events import AliveWatch, DeadlineWatch, EventStatus
from day6_core.graph.node import Node
from day6_core.graph.qos import Durability

STRING = "std_msgs/msg/String"
LATCHED = QoS(depth=20, durability=Durability.TRANSIENT_LOCAL)
ROUNDS = 300


@pytest.fixture(autouse=True)
def _restless() -> Iterator[None]:
    before = sys.getswitchinterval()
    sys.setswitchinterval(1e-6)
    yield
    sys.setswitchinterval(before)


def side_by_side(*actions: Callable[[], object]) -> None:
    """Run these in a thread each, all at once; raise what one of them raised."""
    start = threading.Barrier(len(actions))
    raised: list[BaseException] = []

    def run(action: Callable[[], object]) -> None:
        start.wait()
        try:
            action()
        except BaseException as error:
            raised.append(error)

    threads = [threading.Thread(target=run, args=(action,)) for action in actions]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join()
    if raised:
        raise raised[0]


def take_all(subscription: Subscription) -> list[Any]:
    found = []
    while (sample := subscription.take()) is not None:
        found.append(sample[0])
    return found


def test_a_late_joiner_gets_every_latched_message_once_and_in_order() -> None:
    wrong = []
    for _ in range(ROUNDS):
        node = Graph().create_node("node")
        publisher = node.create_publisher("/map", STRING, "hash", LATCHED, list)
        joined: list[Subscription] = []

        def publish(publisher: Any = publisher) -> None:
            for number in range(10):
                publisher.publish([number])

        def join(node: Node = node, joined: list[Subscription] = joined) -> None:
            joined.append(node.create_subscription("/map", STRING, "hash", LATCHED))

        side_by_side(publish, join)
        got = [message for [message] in take_all(joined[0])]
        if got != list(range(10)):
            wrong.append(got)
    assert not wrong


def test_leases_are_counted_while_publishers_come_and_go() -> None:
    status = EventStatus()
    watch = AliveWatch(10, status)

    def come_and_go(first: int) -> None:
        for number in range(first, first + 400):
            watch.asserted(number, number)
            if number % 2:
                watch.gone(number, number)

    def settle() -> None:
        for now in range(1000):
            watch.settle(now)
            assert watch.due is None or watch.due > 0

    side_by_side(lambda: come_and_go(0), lambda: come_and_go(1000), settle, settle)
    watch.settle(10_000)
    assert (status.current_count, status.not_alive_count) == (0, 400)


def test_periods_are_missed_once_whoever_looks() -> None:
    status = EventStatus()
    watch = DeadlineWatch(1, status)
    watch.message(0)

    def settle() -> None:
        for now in range(2000):
            watch.settle(now)

    side_by_side(settle, settle, settle)
    assert status.total_count == 1999


def test_a_change_is_taken_by_one_of_several() -> None:
    status = EventStatus()
    taken: list[int] = []
    side_by_side(
        lambda: [status.add() for _ in range(3000)],
        lambda: taken.extend(status.take().total_count_change for _ in range(3000)),
    )
    assert sum(taken) + status.take().total_count_change == status.total_count == 3000


def test_matches_are_counted_while_they_are_taken() -> None:
    node = Graph().create_node("node")
    publisher = node.create_publisher("/chatter", STRING, "hash", QoS(), list)
    changes: list[int] = []

    def come_and_go() -> None:
        for _ in range(300):
            node.create_subscription("/chatter", STRING, "hash", QoS()).destroy()

    side_by_side(
        come_and_go,
        lambda: changes.extend(publisher.take_event(EventKind.MATCHED).current_count_change for _ in range(3000)),
    )
    assert sum(changes) + publisher.take_event(EventKind.MATCHED).current_count_change == 0
