"""Delivery, QoS, graph events: what a teacher says about topics, proved on the bare graph."""

from __future__ import annotations

import threading
from typing import Any

import pytest

from day6_core.graph import EndpointKind, Graph, GraphEvent, QoS
from day6_core.graph.endpoints import Endpoint, EventKind, Publisher, Subscription
from day6_core.graph.graph import Change, graph_for_domain
from day6_core.graph.matching import connect
from day6_core.graph.node import Node
from day6_core.graph.qos import (
    Durability,
    History,
    Liveliness,
    PolicyKind,
    Reliability,
    incompatible_policies,
)

STRING = "std_msgs/msg/String"


def publisher(node: Node, topic: str = "/chatter", qos: QoS | None = None, type_name: str = STRING) -> Publisher:
    return node.create_publisher(topic, type_name, "hash", qos or QoS(), list)


def subscription(node: Node, topic: str = "/chatter", qos: QoS | None = None, type_name: str = STRING) -> Subscription:
    return node.create_subscription(topic, type_name, "hash", qos or QoS())


def received(endpoint: Subscription) -> list[Any]:
    found = []
    while (sample := endpoint.take()) is not None:
        found.append(sample[0])
    return found


@pytest.fixture
def graph() -> Graph:
    return Graph()


@pytest.fixture
def node(graph: Graph) -> Node:
    return graph.create_node("n")


def test_every_subscriber_gets_its_own_copy(node: Node) -> None:
    pub, first, second = publisher(node), subscription(node), subscription(node)
    message = ["hello"]
    pub.publish(message)
    message.append("changed after publishing")
    (one,), (two,) = received(first), received(second)
    assert one == two == ["hello"]
    assert one is not two


def test_a_message_carries_times_numbers_and_the_publishers_gid(graph: Graph, node: Node) -> None:
    graph.now_ns = lambda: 123
    pub, sub = publisher(node), subscription(node)
    for _ in range(2):
        pub.publish([])
    graph.now_ns = lambda: 456  # they were not taken when they came
    infos = [sub.message_info(sample) for _ in range(2) if (sample := sub.take())]
    assert [info.publication_sequence_number for info in infos] == [1, 2]
    assert [info.reception_sequence_number for info in infos] == [1, 2]
    assert {(info.source_timestamp, info.received_timestamp) for info in infos} == {(123, 123)}
    assert infos[0].publisher_gid == pub.gid
    assert len(pub.gid) == 16
    assert pub.gid != sub.gid


def test_a_full_queue_drops_its_oldest_message(node: Node) -> None:
    pub, sub = publisher(node), subscription(node, qos=QoS(depth=3))
    for number in range(5):
        pub.publish([number])
    assert received(sub) == [[2], [3], [4]]
    assert sub.dropped == 2


def test_keep_all_keeps_what_keep_last_would_drop(node: Node) -> None:
    pub, sub = publisher(node), subscription(node, qos=QoS(depth=1, history=History.KEEP_ALL))
    for number in range(100):
        pub.publish([number])
    assert len(received(sub)) == 100


def test_a_latched_topic_keeps_its_last_messages_for_late_joiners(node: Node) -> None:
    latched = QoS(depth=2, durability=Durability.TRANSIENT_LOCAL)
    pub = publisher(node, qos=latched)
    for number in range(4):
        pub.publish([number])
    assert received(subscription(node, qos=latched)) == [[2], [3]]
    assert received(subscription(node, qos=latched._replace(depth=1))) == [[3]]
    assert received(subscription(node)) == [], "a volatile subscription asks for nothing old"


def test_a_late_joiner_hears_nothing_old_from_a_volatile_topic(node: Node) -> None:
    pub = publisher(node)
    pub.publish(["old"])
    sub = subscription(node)
    pub.publish(["new"])
    assert received(sub) == [["new"]]


def test_a_message_older_than_its_lifespan_is_not_taken(graph: Graph, node: Node) -> None:
    now = [0]
    graph.now_ns = lambda: now[0]
    pub, sub = publisher(node), subscription(node, qos=QoS(lifespan=1000))
    pub.publish(["stale"])
    now[0] = 500
    pub.publish(["fresh"])
    now[0] = 1200
    assert received(sub) == [["fresh"]]


def test_a_late_joiner_gets_nothing_that_outlived_the_publishers_lifespan(graph: Graph, node: Node) -> None:
    now = [0]
    graph.now_ns = lambda: now[0]
    latched = QoS(durability=Durability.TRANSIENT_LOCAL)
    pub = publisher(node, qos=latched._replace(lifespan=1000))
    early = subscription(node)
    pub.publish(["stale"])
    now[0] = 500
    pub.publish(["fresh"])
    now[0] = 1200
    assert received(early) == [["stale"], ["fresh"]], "what has been delivered stays"
    assert received(subscription(node, qos=latched)) == [["fresh"]]


OFFER_AND_REQUEST = [
    ({}, {}, []),
    ({"reliability": Reliability.BEST_EFFORT}, {}, [PolicyKind.RELIABILITY]),
    ({}, {"reliability": Reliability.BEST_EFFORT}, []),
    ({}, {"durability": Durability.TRANSIENT_LOCAL}, [PolicyKind.DURABILITY]),
    ({"durability": Durability.TRANSIENT_LOCAL}, {}, []),
    ({}, {"deadline": 10}, [PolicyKind.DEADLINE]),
    ({"deadline": 10}, {"deadline": 10}, []),
    ({"deadline": 11}, {"deadline": 10}, [PolicyKind.DEADLINE]),
    ({"deadline": 10}, {}, []),
    ({}, {"liveliness": Liveliness.MANUAL_BY_TOPIC}, [PolicyKind.LIVELINESS]),
    ({"liveliness": Liveliness.MANUAL_BY_TOPIC}, {}, []),
    ({}, {"liveliness_lease_duration": 5}, [PolicyKind.LIVELINESS]),
    ({"liveliness_lease_duration": 5}, {"liveliness_lease_duration": 6}, []),
    ({"lifespan": 10**12}, {"lifespan": 10**11}, []),
    ({"history": History.KEEP_ALL}, {"depth": 1}, []),
]


@pytest.mark.parametrize(("offer", "request_", "expected"), OFFER_AND_REQUEST)
def test_offers_and_requests_match_as_in_dds(
    offer: dict[str, Any], request_: dict[str, Any], expected: list[PolicyKind]
) -> None:
    assert incompatible_policies(QoS(**offer).resolved(), QoS(**request_).resolved()) == expected


@pytest.mark.parametrize(("offer", "request_", "expected"), OFFER_AND_REQUEST)
def test_messages_flow_only_between_matching_endpoints(
    node: Node, offer: dict[str, Any], request_: dict[str, Any], expected: list[PolicyKind]
) -> None:
    pub, sub = publisher(node, qos=QoS(**offer)), subscription(node, qos=QoS(**request_))
    pub.publish(["x"])
    assert received(sub) == ([] if expected else [["x"]])
    assert pub.subscription_count == sub.publisher_count == (0 if expected else 1)


def test_incompatible_qos_is_reported_once_to_both_sides(node: Node) -> None:
    heard: list[tuple[str, EventKind]] = []
    pub = publisher(node, qos=QoS(reliability=Reliability.BEST_EFFORT))
    pub.on_event = lambda endpoint, kind: heard.append((endpoint.kind.value, kind))
    sub = subscription(node)
    subscription(node, topic="/other")
    publisher(node, topic="/chatter")
    assert heard == [("MP", EventKind.INCOMPATIBLE_QOS)]
    status = sub.take_event(EventKind.INCOMPATIBLE_QOS)
    assert (status.total_count, status.total_count_change) == (1, 1)
    assert status.last_policy_kind == PolicyKind.RELIABILITY
    assert sub.take_event(EventKind.INCOMPATIBLE_QOS).total_count_change == 0


def test_matching_is_counted_up_and_down(node: Node) -> None:
    pub, sub = publisher(node), subscription(node)
    assert pub.take_event(EventKind.MATCHED).current_count == 1
    sub.destroy()
    status = pub.take_event(EventKind.MATCHED)
    assert (status.current_count, status.current_count_change, status.total_count) == (0, -1, 1)


def test_two_types_on_one_topic_do_not_meet(node: Node) -> None:
    pub, sub = publisher(node), subscription(node, type_name="std_msgs/msg/Int32")
    pub.publish(["x"])
    assert received(sub) == []
    assert node.graph.names_and_types(EndpointKind.PUBLISHER, EndpointKind.SUBSCRIPTION) == [
        ("/chatter", ["std_msgs/msg/Int32", STRING])
    ]


def test_a_request_finds_its_server_and_the_answer_its_client(node: Node) -> None:
    server = node.create_service("/add", "T", "hash", QoS(), list)
    asker = node.create_client("/add", "T", "hash", QoS(), list)
    other = node.create_client("/add", "T", "hash", QoS(), list)
    assert asker.service_is_ready()
    number = asker.send_request([1, 2])
    taken = server.take()
    assert taken is not None
    request, request_id = taken
    assert request == [1, 2]
    server.send_response(request_id, [3])
    assert asker.take() == ([3], number)
    assert other.take() is None
    server.destroy()
    assert not asker.service_is_ready()


def test_graph_events_tell_of_everything_that_comes_and_goes(graph: Graph) -> None:
    events: list[GraphEvent] = []
    remove = graph.add_listener(events.append)
    node = graph.create_node("n", "/team")
    pub = publisher(node)
    node.destroy()
    node.destroy()
    remove()
    graph.create_node("unheard")
    assert [(event.change, event.subject) for event in events] == [
        (Change.NODE_ADDED, node),
        (Change.ENDPOINT_ADDED, pub),
        (Change.ENDPOINT_REMOVED, pub),
        (Change.NODE_REMOVED, node),
    ]
    assert node.full_name == "/team/n"
    assert graph.find_nodes("n", "/team") == []


def test_a_listener_may_change_the_graph(graph: Graph) -> None:
    def mirror(event: GraphEvent) -> None:
        if event.change is Change.NODE_ADDED and isinstance(event.subject, Node) and event.subject.name == "first":
            graph.create_node("second")

    graph.add_listener(mirror)
    graph.create_node("first")
    assert [node.name for node in graph.nodes] == ["first", "second"]


def test_a_listener_that_fails_keeps_nothing_from_the_others(graph: Graph, caplog: pytest.LogCaptureFixture) -> None:
    heard: list[GraphEvent] = []

    def fail(_: GraphEvent) -> None:
        raise RuntimeError("no")

    graph.add_listener(fail)
    graph.add_listener(heard.append)
    node = graph.create_node("first")
    assert graph.nodes == (node,) and [event.subject for event in heard] == [node]
    assert "a listener of the graph failed" in caplog.text


def test_many_threads_may_publish_and_change_the_graph_at_once(graph: Graph) -> None:
    node = graph.create_node("n")
    pub, sub = publisher(node), subscription(node, qos=QoS(history=History.KEEP_ALL))
    failures: list[BaseException] = []

    def work(index: int) -> None:
        try:
            for number in range(200):
                pub.publish([index, number])
                subscription(node, topic=f"/t{index}").destroy()
                subscription(node).destroy()
        except BaseException as error:
            failures.append(error)

    threads = [threading.Thread(target=work, args=(index,)) for index in range(4)]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join()
    assert failures == []
    assert len(received(sub)) == 800
    assert sub.publisher_count == 1


def test_endpoints_of_other_processes_are_counted_but_not_joined_to_each_other(graph: Graph) -> None:
    here, there = graph.create_node("here"), graph.create_node("there", origin="peer")
    local_pub, remote_pub = publisher(here), publisher(there)
    local_sub, remote_sub = subscription(here), subscription(there)
    assert local_pub.matched == (local_sub,)
    assert local_pub.remote_matched == (remote_sub,)
    assert local_pub.subscription_count == 2
    assert remote_pub.matched == (local_sub,)
    assert local_sub.publisher_count == 2
    assert remote_sub.matched == (local_pub,)
    remote_pub.deliver(["from afar"], 5, 1)
    assert received(local_sub) == [["from afar"]]


def test_one_graph_per_domain() -> None:
    assert graph_for_domain(41) is graph_for_domain(41)
    assert graph_for_domain(41) is not graph_for_domain(42)


def test_what_nobody_hears_is_numbered_and_counted(node: Node) -> None:
    pub = publisher(node)
    pub.publish(["unheard"])
    pub.publish_unheard(3)
    sub = subscription(node)
    pub.publish(["heard"])
    sample = sub.take()
    assert sample is not None and (sample[0], sample[2]) == (["heard"], 5)
    assert pub.delivered == 5


def test_a_publisher_knows_whether_its_moment_matters_to_anybody(node: Node) -> None:
    assert not publisher(node).is_attended
    assert publisher(node, qos=QoS(durability=Durability.TRANSIENT_LOCAL)).is_attended
    assert publisher(node, qos=QoS(deadline=1_000_000_000)).is_attended
    heard = publisher(node, "/heard")
    listener = subscription(node, "/heard")
    assert heard.is_attended
    listener.destroy()
    assert not heard.is_attended
    counted = publisher(node, "/counted")
    assert counted.delivered == 0 and counted.is_attended


def test_an_endpoint_looks_only_at_those_it_can_be_matched_with(
    graph: Graph, node: Node, monkeypatch: pytest.MonkeyPatch
) -> None:
    # Every node publishes /rosout and /parameter_events: with a thousand nodes they would all look at each other.
    looked: list[int] = []

    def counted(endpoint: Endpoint, others: tuple[Endpoint, ...], raised: Any) -> None:
        looked.append(len(others))
        connect(endpoint, others, raised)

    monkeypatch.setattr("day6_core.graph.graph.connect", counted)
    publishers = [publisher(node) for _ in range(100)]
    listener = subscription(node)
    assert sum(looked[:100]) == 0 and looked[100] == len(listener.matched) == 100
    publishers[50].destroy()
    assert listener.matched == (*publishers[:50], *publishers[51:])
    assert graph.endpoints(EndpointKind.PUBLISHER) == list(listener.matched)
