"""The watches over deadlines and leases by themselves: what they count, what they answer, when something is due."""

from __future__ import annotations

import pytest

from day6_core.graph import Graph
from day6_core.graph.events import AliveWatch, DeadlineWatch, EventKind, EventStatus, LeaseWatch
from day6_core.graph.node import Node
from day6_core.graph.qos import INFINITE_NS, Liveliness, PolicyKind, QoS


def alive(status: EventStatus) -> tuple[int, int]:
    return status.current_count, status.not_alive_count


def test_a_status_counts_and_forgets_its_changes_when_it_is_taken() -> None:
    status = EventStatus()
    assert status.last_policy_kind == PolicyKind.INVALID
    status.add()
    status.add(3)
    status.add_alive(2, 1)
    status.add_alive(-1, 1)
    taken = status.take()
    assert (taken.total_count, taken.total_count_change) == (4, 4)
    assert (taken.current_count, taken.current_count_change) == (1, 1)
    assert (taken.not_alive_count, taken.not_alive_count_change) == (2, 2)
    again = status.take()
    assert (again.total_count, again.total_count_change) == (4, 0)
    assert (again.current_count, again.current_count_change) == (1, 0)
    assert (again.not_alive_count, again.not_alive_count_change) == (2, 0)


@pytest.mark.parametrize(
    ("later", "missed", "due"),
    [(0, 0, 110), (9, 0, 110), (10, 1, 120), (11, 1, 120), (19, 1, 120), (20, 2, 130), (35, 3, 140)],
)
def test_a_deadline_counts_whole_periods_since_the_last_message(later: int, missed: int, due: int) -> None:
    status = EventStatus()
    watch = DeadlineWatch(10, status)
    watch.settle(1000)
    assert (watch.due, status.total_count) == (None, 0)
    assert watch.message(100)
    watch.settle(100 + later)
    assert (status.total_count, watch.due) == (missed, due)
    watch.settle(100 + later)
    assert status.total_count == missed
    assert not watch.message(100 + later)
    assert watch.due == 110 + later


def test_a_lease_runs_out_once() -> None:
    status = EventStatus()
    watch = LeaseWatch(10, status)
    watch.settle(1000)
    assert (watch.due, status.total_count) == (None, 0)
    assert watch.asserted(100)
    assert watch.due == 110
    assert not watch.asserted(109)
    watch.settle(118)
    assert (watch.due, status.total_count) == (119, 0)
    watch.settle(119)
    assert (watch.due, status.total_count) == (None, 1)
    watch.settle(500)
    assert status.total_count == 1
    assert watch.asserted(500)
    assert watch.asserted(510), "that one had run out just then"
    assert status.total_count == 2


def test_publishers_come_to_life_and_die_one_by_one() -> None:
    status = EventStatus()
    watch = AliveWatch(10, status)
    assert watch.due is None
    assert watch.asserted("a", 100)
    assert watch.asserted("b", 105)
    assert not watch.asserted("b", 106)
    assert (alive(status), watch.due) == ((2, 0), 110)
    watch.settle(109)
    assert alive(status) == (2, 0)
    watch.settle(110)
    assert (alive(status), watch.due) == ((1, 1), 116)
    watch.settle(111)
    assert alive(status) == (1, 1)
    assert watch.asserted("a", 112)
    assert (alive(status), watch.due) == ((2, 0), 116)
    watch.settle(200)
    assert (alive(status), watch.due) == ((0, 2), None)
    assert status.take().current_count_change == 0


def test_a_publisher_that_lives_for_ever_is_never_due() -> None:
    status = EventStatus()
    watch = AliveWatch(10, status)
    assert watch.asserted("a", 100, for_ever=True)
    assert not watch.asserted("a", 101, for_ever=True)
    assert watch.due is None
    watch.settle(INFINITE_NS - 1)
    assert alive(status) == (1, 0)
    assert watch.gone("a", 200)
    assert alive(status) == (0, 0)


def test_a_publisher_that_goes_is_news_if_it_was_known() -> None:
    status = EventStatus()
    watch = AliveWatch(10, status)
    assert not watch.gone("never", 100)
    assert alive(status) == (0, 0)
    for name in ("living", "dead"):
        watch.asserted(name, 100)
    watch.asserted("living", 105)
    assert watch.gone("dead", 112)
    assert alive(status) == (1, 0)
    assert watch.gone("living", 113)
    assert alive(status) == (0, 0)
    assert not watch.gone("living", 114)
    assert watch.due is None


@pytest.fixture
def node() -> Node:
    graph = Graph()
    graph.now_ns = lambda: 1000
    return graph.create_node("n")


def test_inside_one_process_nobody_hears_that_automatic_publishers_live(node: Node) -> None:
    automatic = QoS(liveliness=Liveliness.AUTOMATIC, liveliness_lease_duration=100)
    sub = node.create_subscription("/t", "T", "", automatic)
    node.create_publisher("/t", "T", "", automatic, list).publish(["x"])
    assert alive(sub.status(EventKind.LIVELINESS_CHANGED)) == (0, 0)
    far = node.graph.create_node("far", origin="peer")
    told: list[EventKind] = []
    sub.on_event = lambda _, kind: told.append(kind)
    publisher = far.create_publisher("/t", "T", "", automatic, list)
    assert alive(sub.status(EventKind.LIVELINESS_CHANGED)) == (1, 0)
    assert sorted(told, key=str) == [EventKind.LIVELINESS_CHANGED, EventKind.MATCHED]
    told.clear()
    publisher.destroy()
    assert sorted(told, key=str) == [EventKind.LIVELINESS_CHANGED, EventKind.MATCHED]


@pytest.mark.parametrize("with_a_message", [True, False])
def test_the_first_sign_of_life_and_the_first_message_are_told(node: Node, with_a_message: bool) -> None:
    qos = QoS(liveliness=Liveliness.MANUAL_BY_TOPIC, liveliness_lease_duration=100, deadline=50)
    pub, sub = node.create_publisher("/t", "T", "", qos, list), node.create_subscription("/t", "T", "", qos)
    told: list[tuple[str, EventKind]] = []
    pub.on_event = sub.on_event = lambda endpoint, kind: told.append((endpoint.kind.value, kind))
    for _ in range(2):
        pub.publish(["x"]) if with_a_message else pub.assert_liveliness()
    expected = [("MP", EventKind.LIVELINESS_LOST), ("MS", EventKind.LIVELINESS_CHANGED)]
    if with_a_message:
        expected += [("MP", EventKind.DEADLINE_MISSED), ("MS", EventKind.DEADLINE_MISSED)]
    assert sorted(told, key=str) == sorted(expected, key=str)
