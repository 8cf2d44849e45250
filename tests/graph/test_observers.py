"""A node that only looks on hears everything and is nowhere: in no list, no count, no event."""

from __future__ import annotations

from typing import Any

import pytest

from day6_core.graph import EndpointKind, Graph, QoS
from day6_core.graph.endpoints import EventKind
from day6_core.graph.names import OBSERVER_PREFIX, flaw_of_node_name, is_hidden, is_observer
from day6_core.graph.qos import Durability, Reliability

STRING = "std_msgs/msg/String"
ALL = tuple(EndpointKind)


@pytest.fixture
def graph() -> Graph:
    return Graph()


def test_the_name_is_one_ros_allows_and_hides() -> None:
    assert flaw_of_node_name(f"{OBSERVER_PREFIX}_7") is None
    assert is_hidden(OBSERVER_PREFIX) and is_observer(f"{OBSERVER_PREFIX}_7") and not is_observer("_day6")


def test_it_hears_what_is_said_and_what_was_kept(graph: Graph) -> None:
    latched = QoS(durability=Durability.TRANSIENT_LOCAL)
    publisher = graph.create_node("talker").create_publisher("/chatter", STRING, "hash", latched, list)
    publisher.publish(["before"])
    heard = graph.create_node(f"{OBSERVER_PREFIX}_1").create_subscription("/chatter", STRING, "hash", latched)
    publisher.publish(["after"])
    assert [sample[0] for sample in heard.queue] == [["before"], ["after"]]


def test_no_query_names_or_counts_it(graph: Graph) -> None:
    talker, observer = graph.create_node("talker"), graph.create_node(OBSERVER_PREFIX)
    publisher = talker.create_publisher("/chatter", STRING, "hash", QoS(), list)
    observer.create_subscription("/chatter", STRING, "hash", QoS())
    observer.create_subscription("/silence", STRING, "hash", QoS())
    observer.create_client("/add", "a/srv/B", "hash", QoS(), list)
    assert graph.nodes == (talker,) and graph.observers == (observer,)
    assert graph.find_nodes(OBSERVER_PREFIX, "/") == []
    assert graph.endpoints(*ALL) == [publisher]
    assert graph.names_and_types(*ALL) == [("/chatter", [STRING])]
    assert publisher.subscription_count == 0
    graph.remove_node(observer)
    assert graph.observers == () and publisher.matched == ()


def test_its_coming_and_going_raises_no_event(graph: Graph) -> None:
    publisher = graph.create_node("talker").create_publisher("/chatter", STRING, "hash", QoS(), list)
    picky = QoS(reliability=Reliability.BEST_EFFORT)
    other = graph.create_node("weak").create_publisher("/chatter", STRING, "hash", picky, list)
    raised: list[Any] = []
    publisher.on_event = other.on_event = lambda endpoint, kind: raised.append(kind)
    observer = graph.create_node(OBSERVER_PREFIX)
    heard = observer.create_subscription("/chatter", STRING, "hash", QoS())
    assert heard.matched == (publisher,), "the other one's QoS keep it from hearing, and nobody is told"
    observer.destroy()
    assert raised == []
    assert not any(publisher.status(kind).total_count for kind in EventKind)
    assert not any(other.status(kind).total_count for kind in EventKind)


def test_its_own_publishers_are_not_counted_either(graph: Graph) -> None:
    listener = graph.create_node("listener").create_subscription("/chatter", STRING, "hash", QoS())
    publisher = graph.create_node(OBSERVER_PREFIX).create_publisher("/chatter", STRING, "hash", QoS(), list)
    publisher.publish(["hello"])
    assert len(listener.queue) == 1 and listener.publisher_count == 0
    assert listener.status(EventKind.MATCHED).total_count == 0
