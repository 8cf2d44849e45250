"""Messages, requests and announcements, as they are handed to the engine and taken from it; no session is opened."""

from __future__ import annotations

import threading
from types import SimpleNamespace
from typing import Any

import pytest
import zenoh
import zenoh.ext

from day6_core.graph import Graph, QoS
from day6_core.graph.endpoints import Client, Publisher, RequestId, Service, Subscription
from day6_core.graph.qos import Durability, Reliability
from day6_core.interfaces import deserialize, get_message, get_service, serialize
from day6_core.link import services as services_module
from day6_core.link import topics as topics_module
from day6_core.link.announcing import Announcements
from day6_core.link.attachment import pack, unpack
from day6_core.link.gid import gid_of
from day6_core.link.keys import data_key, endpoint_token, node_token
from day6_core.link.limits import Refusals
from day6_core.link.paths import LinkError
from day6_core.link.remote import Origin, RemoteGraph
from day6_core.link.services import Services
from day6_core.link.topics import Topics
from tests.link.clock import Clock
from tests.link.fake_engine import Declared, FakeQuery, FakeSession, sample

String = get_message("std_msgs/msg/String")
Add = get_service("example_interfaces/srv/AddTwoInts")
PLAIN = QoS()
LATCHED = QoS(depth=3, durability=Durability.TRANSIENT_LOCAL)
REMOTE = zenoh.Locality.REMOTE
BLOCK, DROP = zenoh.CongestionControl.BLOCK, zenoh.CongestionControl.DROP


def same(message: Any) -> Any:
    return message


class Carriers:
    """Both carriers over one session that goes nowhere."""

    def __init__(self, monkeypatch: pytest.MonkeyPatch, *, never_wait: bool = False) -> None:
        self.clock = Clock()
        monkeypatch.setattr(topics_module, "time", self.clock)
        self.timers: list[tuple[float, Any, tuple[Any, ...]]] = []
        carriers = self

        class Timer:
            daemon = False

            def __init__(self, seconds: float, function: Any, arguments: tuple[Any, ...]) -> None:
                self._entry = (seconds, function, arguments)

            def start(self) -> None:
                assert self.daemon, "it would keep the process alive"
                carriers.timers.append(self._entry)

        monkeypatch.setattr(services_module, "threading", SimpleNamespace(Timer=Timer, RLock=threading.RLock))
        self.session = FakeSession()
        for what in ("publisher", "subscriber"):
            monkeypatch.setattr(
                zenoh.ext,
                f"declare_advanced_{what}",
                lambda session, key, *handler, what=what, **options: session._declare(
                    f"advanced {what}", key, *handler, **options
                ),
            )
        for name in ("CacheConfig", "HistoryConfig"):
            monkeypatch.setattr(zenoh.ext, name, lambda **settings: settings)
        self.graph = Graph()
        self.refusals = Refusals()
        self.problems: list[str] = []
        self.remote = RemoteGraph(self.graph, "0dd", self.refusals, lambda zid: False)
        engine: Any = self.session
        self.topics = Topics(engine, "0dd", self.remote, self._report, self.refusals, never_wait=never_wait)
        self.services = Services(engine, "0dd", self._report, self.refusals)
        self.announcements = Announcements(engine, "0dd", self.topics, self.services)
        self.node = self.graph.create_node("n")
        self.other = self.graph.create_node("m", origin=Origin("abc"))

    def _report(self, what: str, error: Exception) -> None:
        self.problems.append(f"{what}: {error}")

    def publisher(self, qos: QoS = PLAIN, *, heard: bool = False) -> Publisher:
        if heard:
            self.other.create_subscription("/t", "std_msgs/msg/String", "", PLAIN)
        return self.node.create_publisher("/t", "std_msgs/msg/String", "", qos, same)

    def subscription(self, qos: QoS = PLAIN) -> Subscription:
        return self.node.create_subscription("/t", "std_msgs/msg/String", "", qos)

    def service(self) -> Service:
        return self.node.create_service("/s", "example_interfaces/srv/AddTwoInts", "", QoS(), same)

    def client(self, *, served: bool = True) -> Client:
        client = self.node.create_client("/s", "example_interfaces/srv/AddTwoInts", "", QoS(), same)
        if served:
            self.other.create_service("/s", "example_interfaces/srv/AddTwoInts", "", QoS(), same)
        return client

    def gid(self, endpoint: Any) -> bytes:
        return gid_of(endpoint_token(endpoint, "0dd"))


@pytest.fixture
def it(monkeypatch: pytest.MonkeyPatch) -> Carriers:
    return Carriers(monkeypatch)


# -- messages out ------------------------------------------------------------------------------------------------------


@pytest.mark.parametrize(
    ("reliability", "never_wait", "control"),
    [
        (Reliability.RELIABLE, False, BLOCK),
        (Reliability.RELIABLE, True, DROP),
        (Reliability.BEST_EFFORT, False, DROP),
        (Reliability.BEST_EFFORT, True, DROP),
    ],
)
@pytest.mark.parametrize("durability", [Durability.VOLATILE, Durability.TRANSIENT_LOCAL])
def test_only_a_reliable_publisher_waits_for_room_and_never_where_nothing_may_wait(
    monkeypatch: pytest.MonkeyPatch,
    reliability: Reliability,
    never_wait: bool,
    control: zenoh.CongestionControl,
    durability: Durability,
) -> None:
    it = Carriers(monkeypatch, never_wait=never_wait)
    publisher = it.publisher(QoS(depth=3, reliability=reliability, durability=durability))
    it.topics.publish(publisher, String(data="x"), 5, 1)
    (declared,) = it.session.declared
    kept: dict[str, Any] = {"cache": {"max_samples": 3}, "publisher_detection": True}
    latched = durability == Durability.TRANSIENT_LOCAL
    assert declared.options == {
        "congestion_control": control,
        "allowed_destination": REMOTE,
        **(kept if latched else {}),
    }
    assert (declared.what, declared.key) == ("advanced publisher" if latched else "publisher", data_key(publisher))


def test_a_message_goes_with_its_number_time_and_sender_and_its_publisher_is_declared_once(it: Carriers) -> None:
    publisher = it.publisher()
    for number in (1, 2):
        it.topics.publish(publisher, String(data="x"), 50 + number, number)
    assert [key for key, _, _ in it.session.sent] == [data_key(publisher)] * 2
    assert [deserialize(payload, String).data for _, payload, _ in it.session.sent] == ["x", "x"]
    assert [unpack(attachment) for _, _, attachment in it.session.sent] == [
        (1, 51, it.gid(publisher)),
        (2, 52, it.gid(publisher)),
    ]
    assert it.session.log == [f"declare publisher {data_key(publisher)}"]
    it.topics.withdraw(publisher)
    it.topics.withdraw(publisher)
    assert it.session.log[1:] == [f"undeclare publisher {data_key(publisher)}"]


def test_the_first_message_waits_two_seconds_for_a_route_to_a_subscription_elsewhere(
    it: Carriers, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(
        it.session, "declare_publisher", lambda key, **options: routeless(it.session._declare("publisher", key))
    )
    it.topics.publish(it.publisher(), String(data="x"), 1, 1)
    assert it.clock.slept == [], "nobody was announced"
    publisher = it.publisher(heard=True)
    it.topics.publish(publisher, String(data="x"), 1, 1)
    assert 2.0 <= it.clock.now - 1000.0 < 2.01 and max(it.clock.slept) <= 0.01
    assert len(it.session.sent) == 2
    it.topics.publish(publisher, String(data="x"), 1, 2)
    assert it.clock.now < 1002.01


def routeless(declared: Declared) -> Declared:
    declared.matching_status.matching = False
    return declared


def test_nothing_is_waited_for_where_there_is_a_route_or_nothing_may_wait(monkeypatch: pytest.MonkeyPatch) -> None:
    for never_wait, route, qos in ((False, True, QoS()), (True, False, QoS()), (False, False, LATCHED)):
        it = Carriers(monkeypatch, never_wait=never_wait)
        opened = it.topics.open(it.publisher(qos, heard=True)).publisher
        opened.matching_status.matching = route
        it.topics.withdraw(next(iter(it.topics._publishers)))
        declare = it.session._declare

        def declared(
            what: str,
            key: Any,
            handler: Any = None,
            declare: Any = declare,
            route: bool = route,
            **options: Any,
        ) -> Declared:
            made: Declared = declare(what, key, handler, **options)
            made.matching_status.matching = route
            return made

        monkeypatch.setattr(it.session, "_declare", declared)
        it.topics.publish(it.publisher(qos), String(data="x"), 1, 1)
        assert it.clock.slept == [] and len(it.session.sent) == 1


def test_what_a_latched_publisher_kept_goes_into_the_cache_once(it: Carriers) -> None:
    publisher = it.publisher(LATCHED)
    for text in "abcd":
        publisher.publish(String(data=text))
    it.topics.publish(publisher, String(data="d"), 4, 4)
    assert [deserialize(payload, String).data for _, payload, _ in it.session.sent] == ["b", "c", "d"]
    it.topics.publish(publisher, String(data="e"), 5, 5)
    assert [unpack(attachment).sequence_number for _, _, attachment in it.session.sent] == [2, 3, 4, 5]


def test_nothing_is_declared_after_the_end(it: Carriers) -> None:
    publisher, subscription, service, client = it.publisher(), it.subscription(), it.service(), it.client()
    it.topics.open(publisher)
    it.topics.close()
    it.services.close()
    with pytest.raises(LinkError, match="the link was closed"):
        it.topics.publish(publisher, String(), 1, 1)
    with pytest.raises(LinkError, match="the link was closed"):
        it.topics.subscribe(subscription)
    with pytest.raises(LinkError, match="the link was closed"):
        it.services.serve(service)
    with pytest.raises(LinkError, match="the link was closed"):
        it.services.send_request(client, Add.Request(), 1)


# -- messages in -------------------------------------------------------------------------------------------------------


def test_a_subscription_hears_others_and_a_latched_one_what_they_kept(it: Carriers) -> None:
    plain, latched = it.subscription(), it.subscription(LATCHED)
    first, second = it.topics.subscribe(plain), it.topics.subscribe(latched)
    assert (first.what, first.key, first.options) == ("subscriber", data_key(plain), {"allowed_origin": REMOTE})
    history = {"detect_late_publishers": True, "max_samples": 3}
    assert (second.what, second.key) == ("advanced subscriber", data_key(latched))
    assert second.options == {"allowed_origin": REMOTE, "history": history}


def remote_publisher(it: Carriers, qos: QoS = PLAIN) -> Publisher:
    token = endpoint_token(it.publisher(qos), "abc")
    it.remote.appear(token)
    found = it.remote._publishers[gid_of(token)]
    assert isinstance(found, Publisher)
    return found


def test_a_message_of_a_known_sender_is_received_and_counted(it: Carriers) -> None:
    subscription = it.subscription()
    sender = remote_publisher(it)
    receiver = it.topics.subscribe(subscription)
    subscription.node.graph.now_ns = lambda: 20
    receiver.call(sample("", serialize(String(data="x")), pack(7, 8, sender.gid)))
    receiver.call(sample("", serialize(String(data="y")), pack(8, 9, sender.gid)))
    subscription.node.graph.now_ns = lambda: 50  # taken later than it came
    assert subscription.take() == (String(data="x"), 8, 7, sender, 20)
    assert subscription.take() == (String(data="y"), 9, 8, sender, 20)
    assert sender.delivered == 2 and it.problems == [] and it.refusals.counts == {}


def test_who_takes_bytes_gets_them_unread_unless_a_filter_has_to_read_them(it: Carriers) -> None:
    subscription = it.subscription()
    sender = remote_publisher(it)
    receiver = it.topics.subscribe(subscription)
    subscription.takes_bytes = True
    subscription.node.graph.now_ns = lambda: 20
    receiver.call(sample("", b"\0\1\0\0 unreadable", pack(7, 8, sender.gid)))
    assert subscription.take() == (b"\0\1\0\0 unreadable", 8, 7, sender, 20)
    subscription.filter_by(lambda message: message.data == "y")
    for data in "xy":
        receiver.call(sample("", serialize(String(data=data)), pack(8, 9, sender.gid)))
    assert subscription.take() == (String(data="y"), 9, 8, sender, 20) and subscription.take() is None
    assert it.problems == [] and sender.delivered == 3


def test_what_is_not_for_a_subscription_is_passed_over_silently(it: Carriers) -> None:
    subscription = it.subscription(QoS(reliability=Reliability.RELIABLE))
    good = serialize(String(data="x"))
    own = it.publisher()
    it.topics.open(own)
    mismatched = remote_publisher(it, QoS(reliability=Reliability.BEST_EFFORT))
    old = remote_publisher(it, QoS(durability=Durability.TRANSIENT_LOCAL, lifespan=10))
    receiver = it.topics.subscribe(subscription)
    receiver.call(sample("", good, None))
    for gid in (it.gid(own), mismatched.gid, old.gid):
        receiver.call(sample("", good, pack(1, 8, gid)))
    assert subscription.take() is None and it.problems == []
    receiver.call(sample("", good, pack(1, it.graph.now_ns() + 10**15, old.gid)))
    assert subscription.take() is not None
    subscription.destroy()
    receiver.call(sample("", good, pack(1, 8, b"\1" * 16)))
    assert subscription.take() is None and it.problems == [] and it.refusals.counts == {}


def test_a_message_that_cannot_be_read_is_counted_and_told(it: Carriers) -> None:
    receiver = it.topics.subscribe(it.subscription())
    receiver.call(sample("", b"", b"short"))
    receiver.call(sample("", b"\0\1\0\0\xff\xff\xff\xff", pack(1, 1, bytes(16))))
    assert it.refusals.counts == {"messages": 2}
    assert [problem.partition(":")[0] for problem in it.problems] == ["a message on /t was lost"] * 2


# -- requests in -------------------------------------------------------------------------------------------------------


def asked(number: int, gid: bytes = b"\1" * 16, a: int = 1, b: int = 2) -> FakeQuery:
    return FakeQuery(serialize(Add.Request(a=a, b=b)), pack(number, 9, gid))


def test_a_server_is_a_complete_queryable_for_others(it: Carriers) -> None:
    service = it.service()
    made = it.services.serve(service)
    assert (made.what, made.key) == ("queryable", data_key(service))
    assert made.options == {"complete": True, "allowed_origin": REMOTE}


def test_a_request_is_answered_once_to_who_sent_it(it: Carriers) -> None:
    it.graph.now_ns = lambda: 1234
    service = it.service()
    made = it.services.serve(service)
    query, other = asked(7), asked(7, b"\2" * 16)
    for each in (query, other):
        made.call(each)
    request, request_id = service.take() or (None, None)
    assert request == Add.Request(a=1, b=2) and request_id == RequestId(b"\1" * 16, 7)
    for _ in range(2):
        it.services.send_response(service, request_id, Add.Response(sum=3))
    it.services.send_response(service, RequestId(b"\1" * 16, 8), Add.Response(sum=3))
    (reply,) = query.replies
    assert reply["key"] == data_key(service)
    assert deserialize(reply["payload"], Add.Response).sum == 3
    assert unpack(reply["attachment"]) == (7, 1234, b"\1" * 16)
    assert (query.dropped, other.dropped, other.replies) == (1, 0, [])


def test_the_same_request_twice_is_served_once_and_the_second_query_ends(it: Carriers) -> None:
    service = it.service()
    made = it.services.serve(service)
    first, second = asked(7), asked(7)
    made.call(first)
    made.call(second)
    assert len(service.queue) == 1
    assert (first.dropped, second.dropped) == (0, 1)


@pytest.mark.parametrize(
    ("query", "told"),
    [
        (FakeQuery(None, pack(1, 1, bytes(16))), False),
        (FakeQuery(serialize(Add.Request()), None), False),
        (FakeQuery(serialize(Add.Request()), b"short"), True),
        (FakeQuery(b"", pack(1, 1, bytes(16))), True),
    ],
)
def test_a_query_that_is_no_request_ends_at_once(it: Carriers, query: FakeQuery, told: bool) -> None:
    service = it.service()
    it.services.serve(service).call(query)
    assert query.dropped == 1 and len(service.queue) == 0
    assert it.refusals.counts == ({"messages": 1} if told else {})
    assert [problem.partition(":")[0] for problem in it.problems] == ["a request to /s was lost"] * told


def test_a_server_keeps_so_many_requests_and_lets_the_oldest_go(it: Carriers, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(services_module, "_MOST_OPEN_REQUESTS", 2)
    service = it.service()
    made = it.services.serve(service)
    queries = [asked(number) for number in range(4)]
    for query in queries:
        made.call(query)
    assert [query.dropped for query in queries] == [1, 1, 0, 0]
    assert len(service.queue) == 4
    it.services.send_response(service, RequestId(b"\1" * 16, 0), Add.Response())
    it.services.send_response(service, RequestId(b"\1" * 16, 3), Add.Response())
    assert [len(query.replies) for query in queries] == [0, 0, 0, 1]


@pytest.mark.parametrize("everything", [False, True])
def test_open_requests_end_with_their_server_and_with_the_link(it: Carriers, everything: bool) -> None:
    service = it.service()
    made = it.services.serve(service)
    queries = [asked(number) for number in range(3)]
    for query in queries:
        made.call(query)
    if everything:
        it.services.close()
    else:
        it.services.withdraw(service)
    assert [query.dropped for query in queries] == [1, 1, 1]
    late = asked(9)
    made.call(late)
    assert late.dropped == 1 and len(service.queue) == 3
    it.services.withdraw(service)
    it.services.send_response(service, RequestId(b"\1" * 16, 0), Add.Response())
    assert [query.replies for query in queries] == [[], [], []]


# -- requests out ------------------------------------------------------------------------------------------------------


def test_a_request_goes_to_all_servers_with_no_limit_of_time(it: Carriers) -> None:
    it.graph.now_ns = lambda: 1234
    client = it.client()
    it.services.send_request(client, Add.Request(a=1, b=2), 5)
    it.services.send_request(client, Add.Request(a=1, b=3), 6)
    first, second = it.session.asked
    assert first.key == data_key(client)
    options = dict(first.options)
    assert deserialize(options.pop("payload"), Add.Request) == Add.Request(a=1, b=2)
    assert unpack(options.pop("attachment")) == (5, 1234, it.gid(client))
    assert unpack(second.options["attachment"]) == (6, 1234, it.gid(client))
    assert options.pop("timeout") == 3650 * 24 * 3600, "ten years"
    assert options.pop("cancellation_token") is second.options["cancellation_token"]
    assert options == {
        "target": zenoh.QueryTarget.ALL_COMPLETE,
        "consolidation": zenoh.ConsolidationMode.NONE,
        "congestion_control": BLOCK,
        "priority": zenoh.Priority.INTERACTIVE_HIGH,
        "allowed_destination": REMOTE,
    }


def reply_of(payload: bytes, attachment: bytes | None) -> Any:
    return SimpleNamespace(ok=sample("", payload, attachment))


def test_each_response_arrives_with_the_number_of_its_request(it: Carriers) -> None:
    client = it.client()
    it.services.send_request(client, Add.Request(), 5)
    (question,) = it.session.asked
    good = serialize(Add.Response(sum=3))
    question.call(SimpleNamespace(ok=None))
    question.call(reply_of(good, None))
    question.call(reply_of(good, pack(5, 1, bytes(16))))
    assert client.take() == (Add.Response(sum=3), 5)
    assert client.take() is None and it.problems == []
    question.call(reply_of(good, b"short"))
    question.call(reply_of(b"", pack(5, 1, bytes(16))))
    assert it.refusals.counts == {"messages": 2}
    assert [problem.partition(":")[0] for problem in it.problems] == ["a response of /s was lost"] * 2
    client.destroy()
    question.call(reply_of(b"", pack(5, 1, bytes(16))))
    assert it.refusals.counts == {"messages": 2}


def test_a_request_that_found_nobody_is_sent_again_for_half_a_minute_ever_later(it: Carriers) -> None:
    client = it.client()
    it.services.send_request(client, Add.Request(a=4), 5)
    waits = []
    for sent in range(1, 10):
        assert len(it.session.asked) == sent
        it.session.asked[-1].handler.drop()
        if it.timers:
            seconds, again, arguments = it.timers.pop()
            waits.append(seconds)
            again(*arguments)
    assert waits == [0.05, 0.2, 0.5, 1.0, 2.0, 4.0, 8.0, 16.0]
    assert len(it.session.asked) == 9 and it.timers == []
    assert {unpack(each.options["attachment"]) for each in it.session.asked} == {
        unpack(it.session.asked[0].options["attachment"])
    }
    assert {each.options["payload"] for each in it.session.asked} == {serialize(Add.Request(a=4))}


def test_a_request_is_not_sent_again_once_answered_or_when_nobody_serves_or_the_link_has_ended(it: Carriers) -> None:
    answered, unserved = it.client(), it.node.create_client("/u", "example_interfaces/srv/AddTwoInts", "", QoS(), same)
    for client in (answered, unserved):
        it.services.send_request(client, Add.Request(), 1)
    it.session.asked[0].call(reply_of(serialize(Add.Response()), pack(1, 1, bytes(16))))
    for question in it.session.asked:
        question.handler.drop()
    here = it.node.create_client("/here", "example_interfaces/srv/AddTwoInts", "", QoS(), same)
    it.node.create_service("/here", "example_interfaces/srv/AddTwoInts", "", QoS(), same)
    it.services.send_request(here, Add.Request(), 1)
    it.session.asked[-1].handler.drop()
    late = it.client()
    it.services.send_request(late, Add.Request(), 1)
    it.services.close()
    it.session.asked[-1].handler.drop()
    assert it.timers == [] and it.problems == []


def test_who_waits_to_ask_again_gives_up_when_the_server_the_client_or_the_link_has_gone(it: Carriers) -> None:
    def waiting() -> tuple[Client, Any, tuple[Any, ...]]:
        client = it.client()
        it.services.send_request(client, Add.Request(), 1)
        it.session.asked[-1].handler.drop()
        _, again, arguments = it.timers.pop()
        return client, again, arguments

    client, again, arguments = waiting()
    client.destroy()
    sent = len(it.session.asked)
    again(*arguments)
    assert len(it.session.asked) == sent
    _, again, arguments = waiting()
    for endpoint in it.other.endpoints:
        endpoint.destroy()
    sent = len(it.session.asked)
    again(*arguments)
    assert len(it.session.asked) == sent
    _, again, arguments = waiting()
    it.session.fails = True
    again(*arguments)
    assert it.problems == ["a request to /s was lost: no"]
    it.session.fails = False
    _, again, arguments = waiting()
    it.services.close()
    again(*arguments)
    assert it.problems == ["a request to /s was lost: no"]


def test_a_client_that_goes_takes_its_questions_back(it: Carriers) -> None:
    client, other = it.client(), it.client()
    for each in (client, other):
        it.services.send_request(each, Add.Request(), 1)
    it.services.withdraw(client)
    it.services.withdraw(client)
    assert [each.options["cancellation_token"].is_cancelled for each in it.session.asked] == [True, False]


# -- announcements -----------------------------------------------------------------------------------------------------


@pytest.mark.parametrize(
    ("kind", "receiver"),
    [("publisher", None), ("subscription", "subscriber"), ("service", "queryable"), ("client", None)],
)
def test_the_receiver_comes_before_its_token_and_goes_after_it(it: Carriers, kind: str, receiver: str | None) -> None:
    endpoint = getattr(it, kind)()
    token = f"token {endpoint_token(endpoint, '0dd')}"
    heard = [f"{receiver} {data_key(endpoint)}"] if receiver else []
    for _ in range(2):
        it.announcements.follow(endpoint)
    assert it.session.log == [f"declare {each}" for each in (*heard, token)]
    it.session.log.clear()
    endpoint.destroy()
    for _ in range(2):
        it.announcements.follow(endpoint)
    assert it.session.log == [f"undeclare {each}" for each in (token, *heard)]


def test_a_node_is_a_token_and_what_came_and_went_unseen_is_nothing(it: Carriers) -> None:
    it.announcements.follow(it.node)
    assert it.session.log == [f"declare token {node_token(it.node, '0dd')}"]
    gone = it.subscription()
    gone.destroy()
    it.announcements.follow(gone)
    assert len(it.session.log) == 1
    it.announcements.clear()
    it.node.destroy()
    it.announcements.follow(it.node)
    assert len(it.session.log) == 1


def test_what_was_kept_is_there_for_others_as_soon_as_its_publisher_is_announced(it: Carriers) -> None:
    publisher = it.publisher(LATCHED)
    it.announcements.follow(publisher)
    assert it.session.keys("advanced publisher") == []
    publisher.publish(String(data="x"))
    latched = it.node.create_publisher("/v", "std_msgs/msg/String", "", LATCHED, same)
    latched.publish(String(data="y"))
    it.announcements.follow(latched)
    assert it.session.keys("advanced publisher") == [data_key(latched)]
    assert [deserialize(payload, String).data for _, payload, _ in it.session.sent] == ["y"]
    latched.destroy()
    it.announcements.follow(latched)
    assert it.session.keys("advanced publisher") == []


def test_an_endpoint_that_goes_takes_what_it_has_open_along(it: Carriers) -> None:
    service, client = it.service(), it.client()
    for each in (service, client):
        it.announcements.follow(each)
    query = asked(1)
    it.session.one("queryable").call(query)
    it.services.send_request(client, Add.Request(), 1)
    for each in (service, client):
        each.destroy()
        it.announcements.follow(each)
    assert query.dropped == 1
    assert it.session.asked[0].options["cancellation_token"].is_cancelled
