"""What goes to other processes and what does not, by a transport that only writes down; GIDs, entity numbers, callbacks."""

from __future__ import annotations

from typing import Any

import pytest

from day6_core.graph import EndpointKind, Graph, QoS
from day6_core.graph.endpoints import Client, EventKind, Publisher, RequestId, Service, Subscription
from day6_core.graph.node import Node
from day6_core.graph.qos import Durability, Liveliness, Reliability

LATCHED = QoS(durability=Durability.TRANSIENT_LOCAL)


class Wire:
    """Writes down what it would send."""

    def __init__(self) -> None:
        self.sent: list[tuple[Any, ...]] = []

    def publish(self, publisher: Publisher, message: Any, source_timestamp: int, number: int) -> None:
        self.sent.append(("message", publisher, message, source_timestamp, number))

    def send_request(self, client: Client, request: Any, number: int) -> None:
        self.sent.append(("request", client, request, number))

    def send_response(self, service: Service, request_id: RequestId, response: Any) -> None:
        self.sent.append(("response", service, request_id, response))


@pytest.fixture
def graph() -> Graph:
    graph = Graph()
    graph.now_ns = lambda: 77
    graph.transport = Wire()
    return graph


@pytest.fixture
def here(graph: Graph) -> Node:
    return graph.create_node("here")


@pytest.fixture
def there(graph: Graph) -> Node:
    return graph.create_node("there", origin="peer")


def sent(graph: Graph) -> list[tuple[Any, ...]]:
    assert isinstance(graph.transport, Wire)
    return graph.transport.sent


def publisher(node: Node, qos: QoS | None = None) -> Publisher:
    return node.create_publisher("/t", "T", "", qos or QoS(), list)


def subscription(node: Node, qos: QoS | None = None) -> Subscription:
    return node.create_subscription("/t", "T", "", qos or QoS())


def test_a_message_goes_out_when_somebody_elsewhere_listens(graph: Graph, here: Node, there: Node) -> None:
    pub = publisher(here)
    subscription(here)
    pub.publish(["a"])
    assert sent(graph) == []
    subscription(there)
    pub.publish(["b"])
    assert sent(graph) == [("message", pub, ["b"], 77, 2)]


def test_a_latched_message_always_goes_out(graph: Graph, here: Node) -> None:
    pub = publisher(here, LATCHED)
    pub.publish(["a"])
    assert sent(graph) == [("message", pub, ["a"], 77, 1)]


def test_nothing_goes_out_without_a_transport(graph: Graph, here: Node, there: Node) -> None:
    graph.transport = None
    publisher(here, LATCHED).publish(["a"])
    client = here.create_client("/s", "T", "", QoS(), list)
    there.create_service("/s", "T", "", QoS(), list)
    assert client.send_request([1]) == 1
    service = here.create_service("/s", "T", "", QoS(), list)
    service.send_response(RequestId(b"nobody", 1), [])


def test_requests_go_to_servers_here_and_elsewhere(graph: Graph, here: Node, there: Node) -> None:
    client = here.create_client("/s", "T", "", QoS(), list)
    assert not client.service_is_ready()
    assert client.send_request([0]) == 1
    local = here.create_service("/s", "T", "", QoS(), list)
    assert client.service_is_ready()
    assert client.send_request([1]) == 2
    assert sent(graph) == []
    far = there.create_service("/s", "T", "", QoS(), list)
    assert client.send_request([2]) == 3
    assert sent(graph) == [("request", client, [2], 3)]
    assert [local.take(), local.take(), local.take()] == [
        ([1], RequestId(client.gid, 2)),
        ([2], RequestId(client.gid, 3)),
        None,
    ]
    assert far.take() is None


def test_a_response_goes_to_the_client_that_asked(graph: Graph, here: Node, there: Node) -> None:
    service = here.create_service("/s", "T", "", QoS(), list)
    clients = [here.create_client("/s", "T", "", QoS(), list) for _ in range(2)]
    far = there.create_client("/s", "T", "", QoS(), list)
    service.send_response(RequestId(clients[1].gid, 5), ["mine"])
    assert [each.take() for each in clients] == [None, (["mine"], 5)]
    assert sent(graph) == []
    service.send_response(RequestId(far.gid, 6), ["far"])
    assert sent(graph) == [("response", service, RequestId(far.gid, 6), ["far"])]
    assert far.take() is None
    service.send_response(RequestId(b"unknown", 7), ["lost"])
    assert sent(graph)[1:] == [("response", service, RequestId(b"unknown", 7), ["lost"])]


def test_other_types_do_not_serve(here: Node) -> None:
    client = here.create_client("/s", "T", "", QoS(), list)
    here.create_service("/s", "U", "", QoS(), list)
    here.create_service("/other", "T", "", QoS(), list)
    assert not client.service_is_ready()
    service = here.create_service("/s", "T", "", QoS(), list)
    assert client.matched == (service,)
    assert service.matched == (client,)
    client.destroy()
    assert service.matched == ()


def test_queues_of_services_and_clients_announce_themselves(here: Node) -> None:
    ready: list[Any] = []
    service = here.create_service("/s", "T", "", QoS(depth=2), list)
    client = here.create_client("/s", "T", "", QoS(depth=2), list)
    service.on_ready = ready.append
    client.on_ready = ready.append
    for number in range(3):
        client.send_request([number])
    assert ready == [service] * 3
    taken = [service.take(), service.take(), service.take()]
    assert [each and each[0] for each in taken] == [[1], [2], None]
    ready.clear()
    for number in range(3):
        service.send_response(RequestId(client.gid, number), [number])
    assert ready == [client] * 3
    assert [client.take(), client.take(), client.take()] == [([1], 1), ([2], 2), None]


def test_a_subscription_announces_every_message(here: Node) -> None:
    ready: list[Any] = []
    sub = here.create_subscription("/t", "T", "", QoS(depth=1), on_ready=ready.append)
    pub = publisher(here)
    for number in range(3):
        pub.publish([number])
    assert ready == [sub] * 3
    assert (sub.dropped, pub.delivered) == (2, 3)


def test_gids_and_numbers_are_given_once(graph: Graph, here: Node, there: Node) -> None:
    pubs = [publisher(here), publisher(here)]
    known = there.create_publisher("/t", "T", "", QoS(), list, gid=b"x" * 16)
    assert known.gid == b"x" * 16
    gids = [each.gid for each in pubs]
    assert gids == [each.gid for each in pubs]
    assert len(set(gids)) == 2
    assert gids[0][:12] == gids[1][:12]
    assert [int.from_bytes(each[12:], "big") for each in gids] == [1, 2]
    numbers = [each.entity_id for each in (here, there, *pubs, known)]
    assert numbers == sorted(set(numbers))
    assert graph.next_entity_id() == numbers[-1] + 1
    graph.identify = lambda endpoint: endpoint.topic.encode().ljust(16, b"-")
    assert publisher(here).gid == b"/t--------------"
    assert Graph().new_gid()[:12] != gids[0][:12]


def test_everybody_has_an_origin(here: Node, there: Node) -> None:
    assert (publisher(here).origin, publisher(there).origin) == (None, "peer")
    sub, far = subscription(here), publisher(there)
    far.deliver(["x"], 5, 9)
    sample = sub.take()
    assert sample
    info = sub.message_info(sample)
    assert (info.source_timestamp, info.received_timestamp, info.publication_sequence_number) == (5, 77, 9)
    assert not info.from_intra_process
    publisher(here).publish(["y"])
    sample = sub.take()
    assert sample
    assert sub.message_info(sample).from_intra_process


def test_callbacks_tell_of_matches_and_of_qos_that_does_not_fit(here: Node) -> None:
    told: list[tuple[Any, EventKind]] = []
    pub = publisher(here, QoS(reliability=Reliability.BEST_EFFORT))
    pub.on_event = lambda endpoint, kind: told.append((endpoint, kind))
    strict = subscription(here)
    strict.on_event = pub.on_event
    assert told == [(pub, EventKind.INCOMPATIBLE_QOS)]
    easy = subscription(here, QoS(reliability=Reliability.BEST_EFFORT))
    easy.on_event = pub.on_event
    told.clear()
    pub.destroy()
    assert told == [(easy, EventKind.MATCHED)]
    status = easy.status(EventKind.MATCHED)
    assert (status.total_count, status.current_count, status.current_count_change) == (1, 0, 0)
    other = publisher(here)
    other.on_event = pub.on_event
    told.clear()
    easy.destroy()
    assert told == [(other, EventKind.MATCHED)]
    assert (strict.matched, easy.matched, other.matched) == ((other,), (), (strict,))
    assert strict.status(EventKind.INCOMPATIBLE_QOS).total_count == 1
    assert strict.status(EventKind.INCOMPATIBLE_QOS).last_policy_kind == 16


def test_an_endpoint_that_goes_leaves_the_others_alone(graph: Graph, here: Node, there: Node) -> None:
    pubs, subs = [publisher(here), publisher(here)], [subscription(here), subscription(here), subscription(there)]
    subs[0].destroy()
    subs[0].destroy()
    assert [each.matched for each in pubs] == [(subs[1],)] * 2
    assert [each.remote_matched for each in pubs] == [(subs[2],)] * 2
    assert [each.status(EventKind.MATCHED).current_count for each in pubs] == [2, 2]
    pubs[0].destroy()
    assert (pubs[0].matched, pubs[0].remote_matched) == ((), ())
    assert subs[1].matched == subs[2].matched == (pubs[1],)
    subs[2].destroy()
    assert pubs[1].remote_matched == ()
    assert graph.endpoints(EndpointKind.PUBLISHER, EndpointKind.SUBSCRIPTION) == [pubs[1], subs[1]]
    assert graph.endpoints(EndpointKind.PUBLISHER, topic="/t") == [pubs[1]]
    assert graph.endpoints(EndpointKind.PUBLISHER, topic="/other") == []
    there.destroy()
    assert graph.nodes == (here,)
    assert here.endpoints == (pubs[1], subs[1])


def test_names_are_told_with_their_types(graph: Graph, here: Node) -> None:
    for topic, type_name in (("/b", "U"), ("/a", "T"), ("/b", "T"), ("/b", "U")):
        here.create_publisher(topic, type_name, "", QoS(), list)
    here.create_service("/c", "S", "", QoS(), list)
    assert graph.names_and_types(EndpointKind.PUBLISHER) == [("/a", ["T"]), ("/b", ["T", "U"])]
    assert graph.names_and_types(EndpointKind.SERVICE, EndpointKind.CLIENT) == [("/c", ["S"])]
    assert graph.names_and_types_by_node(here, EndpointKind.PUBLISHER) == [("/a", ["T"]), ("/b", ["T", "U"])]
    assert graph.names_and_types_by_node(here, EndpointKind.CLIENT) == []


def test_nodes_are_found_by_name_and_namespace(graph: Graph, here: Node) -> None:
    lab = graph.create_node("here", "/lab", enclave="/e")
    twin = graph.create_node("here")
    assert graph.find_nodes("here", "/") == [here, twin]
    assert graph.find_nodes("here", "/lab") == [lab]
    assert graph.find_nodes("there", "/") == []
    assert (lab.full_name, lab.enclave, here.full_name, here.enclave) == ("/lab/here", "/e", "/here", "/")


def test_a_graph_goes_on_in_a_forked_child(graph: Graph, here: Node) -> None:
    graph.renew_lock()
    events: list[Any] = []
    graph.add_listener(events.append)
    publisher(here)
    assert len(events) == 1


@pytest.mark.parametrize(
    ("qos", "limit"),
    [
        (QoS(liveliness=Liveliness.MANUAL_BY_TOPIC, liveliness_lease_duration=100), 177),
        (QoS(liveliness=Liveliness.MANUAL_BY_TOPIC), None),
        (QoS(liveliness_lease_duration=100), None),
    ],
)
def test_only_a_manual_publisher_with_a_lease_is_watched(here: Node, qos: QoS, limit: int | None) -> None:
    pub = publisher(here, qos)
    assert pub.due(EventKind.LIVELINESS_LOST) is None
    pub.publish(["x"])
    assert pub.due(EventKind.LIVELINESS_LOST) == limit
    pub.destroy()
    assert pub.due(EventKind.LIVELINESS_LOST) is None
