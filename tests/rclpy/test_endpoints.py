"""Publishers, subscriptions, services and clients: what they take, what arrives, counts, and that destroyed ones are gone."""

from __future__ import annotations

from threading import Event, Thread
from types import SimpleNamespace
from typing import Any

import pytest
from std_msgs.msg import Int32, String
from std_srvs.srv import SetBool, Trigger
from test_msgs.action import Fibonacci

from rclpy.context import Context
from rclpy.duration import Duration
from rclpy.exceptions import InvalidHandle
from rclpy.node import Node
from rclpy.qos import DurabilityPolicy, QoSProfile
from rclpy.serialization import deserialize_message, serialize_message
from rclpy.service_introspection import ServiceIntrospectionState
from rclpy.type_support import check_for_type_support, check_is_valid_msg_type, check_is_valid_srv_type
from rclpy.wait_for_message import wait_for_message
from tests.support.waiting import until


def serve(_request: Any, response: Any) -> Any:
    return response


def test_a_message_arrives_as_it_was_sent(world: Any) -> None:
    node = world.node("n")
    heard: list[Any] = []
    node.create_subscription(String, "t", heard.append, 10)
    publisher = node.create_publisher(String, "t", 10)
    publisher.publish(String(data="as object"))
    publisher.publish(serialize_message(String(data="as bytes")))
    world.settle()
    assert [each.data for each in heard] == ["as object", "as bytes"]
    assert all(isinstance(each, String) for each in heard)


def test_a_raw_subscription_gets_bytes(world: Any) -> None:
    node = world.node("n")
    heard: list[Any] = []
    node.create_subscription(String, "t", heard.append, 10, raw=True)
    node.create_publisher(String, "t", 10).publish(String(data="x"))
    world.settle()
    (data,) = heard
    assert isinstance(data, bytes)
    assert deserialize_message(data, String).data == "x"


@pytest.mark.parametrize("sender", ["this program", "another program of this process", "another process"])
def test_bytes_of_other_programs_are_filled_as_fast_dds_does(world: Any, sender: str) -> None:
    heard: list[bytes] = []
    node = world.node("n")
    subscription = node.create_subscription(String, "t", heard.append, 50, raw=True)
    context = Context._for_session(world.graph, world.time, env={}) if sender.startswith("another program") else None
    other = node if context is None else Node("o", context=context)
    publisher = other.create_publisher(String, "t", 50)
    origin = None if sender != "another process" else world.graph.create_node("o", origin=object())
    for length in (0, 1, 2, 3, 4, 5, 6, 7, 8, 65_314, 65_316):
        message = String(data="x" * length)
        if origin is None:
            publisher.publish(message)
        else:  # as the link does it
            far = SimpleNamespace(origin=origin.origin, node=origin, qos=subscription._endpoint.qos, gid=bytes(16))
            subscription._endpoint.receive((serialize_message(message), 1, 1, far, 1))
    world.settle()
    # What real rclpy 9.1.2 was seen to receive, in the same process and from another one.
    own, others = [9, 10, 11, 12, 13, 14, 15, 16, 17], [12, 12, 12, 12, 16, 16, 16, 16, 20]
    expected = [*own, 65_323, 65_325] if sender == "this program" else [*others, 65_324, 65_325]
    assert [len(each) for each in heard] == expected
    assert [len(deserialize_message(each, String).data) for each in heard[:9]] == list(range(9))
    if context is not None:
        context.shutdown()


@pytest.mark.parametrize("wrong", ["text", 5, None, Int32(), String])
def test_a_publisher_takes_messages_of_its_type_only(world: Any, wrong: Any) -> None:
    publisher = world.node("n").create_publisher(String, "t", 1)
    with pytest.raises(TypeError, match=r"Expected <class 'std_msgs.msg._string.String'>, got"):
        publisher.publish(wrong)


def test_a_callback_with_two_arguments_learns_of_the_message(world: Any) -> None:
    node = world.node("n")
    told: list[Any] = []
    node.create_subscription(String, "t", lambda message, info: told.append((message.data, info)), 10)
    publisher = node.create_publisher(String, "t", 10)
    for word in "ab":
        publisher.publish(String(data=word))
    world.settle()
    assert [word for word, _ in told] == ["a", "b"]
    infos = [info for _, info in told]
    assert [info["publication_sequence_number"] for info in infos] == [1, 2]
    assert {info["reception_sequence_number"] for info in infos} == {None}
    assert all(info["received_timestamp"] >= info["source_timestamp"] > 10**18 for info in infos)
    assert infos[0]["publisher_gid"]["implementation_identifier"] == "rmw_fastrtps_cpp"
    assert infos[0]["publisher_gid"]["data"] == infos[1]["publisher_gid"]["data"]


class Listener:
    """Callbacks of every shape."""

    def __init__(self) -> None:
        self.heard: list[Any] = []

    def one(self, message: Any) -> None:
        self.heard.append(message.data)

    def two(self, message: Any, _info: Any) -> None:
        self.heard.append(message.data)

    def with_default(self, message: Any, more: int = 5) -> None:
        self.heard.append((message.data, more))

    def any_number(self, *messages: Any) -> None:
        self.heard.append(len(messages))

    async def later(self, message: Any) -> None:
        self.heard.append(message.data)

    @staticmethod
    def none() -> None:
        """Take nothing."""

    def three(self, message: Any, info: Any, more: Any) -> None:
        """Take too much."""

    def keyword_only(self, message: Any, *, need: int) -> None:
        """Want something that nobody gives."""

    def keyword_with_default(self, message: Any, *, need: int = 3) -> None:
        self.heard.append((message.data, need))

    def __call__(self, message: Any) -> None:
        self.heard.append(("called", message.data))


@pytest.mark.parametrize(
    ("name", "heard"),
    [
        ("one", ["x"]),
        ("two", ["x"]),
        ("with_default", [("x", 5)]),
        ("any_number", [1]),
        ("later", ["x"]),
        ("keyword_with_default", [("x", 3)]),
        ("__call__", [("called", "x")]),
        ("", [("called", "x")]),
    ],
)
def test_a_callback_may_have_many_shapes(world: Any, name: str, heard: list[Any]) -> None:
    node = world.node("n")
    listener = Listener()
    node.create_subscription(String, "t", getattr(listener, name) if name else listener, 10)
    node.create_publisher(String, "t", 10).publish(String(data="x"))
    world.settle()
    assert listener.heard == heard


@pytest.mark.parametrize("callback", [Listener().none, Listener().three, Listener().keyword_only, 5, None])
def test_a_callback_takes_one_or_two_arguments(world: Any, callback: Any) -> None:
    node = world.node("n")
    with pytest.raises(RuntimeError, match=r"callback should be either be callable with one argument"):
        node.create_subscription(String, "t", callback, 10)
    world.settle()
    assert node.count_subscribers("t") == 0


def test_a_subscription_may_get_another_callback(world: Any) -> None:
    node = world.node("n")
    listener = Listener()
    subscription = node.create_subscription(String, "t", listener.one, 10)
    publisher = node.create_publisher(String, "t", 10)
    subscription.callback = listener.any_number
    publisher.publish(String(data="x"))
    world.settle()
    subscription.callback = lambda message, info: listener.heard.append(len(info))
    publisher.publish(String(data="x"))
    world.settle()
    assert listener.heard == [1, 5]
    with pytest.raises(RuntimeError):
        subscription.callback = None


@pytest.mark.parametrize(
    ("qos", "error", "message"),
    [
        (-1, ValueError, "history depth must be greater than or equal to zero"),
        ("10", TypeError, "Expected QoSProfile or int, but received <class 'str'>"),
        (None, TypeError, "Expected QoSProfile or int, but received <class 'NoneType'>"),
    ],
)
def test_the_qos_of_a_topic_is_a_profile_or_a_depth(world: Any, qos: Any, error: type[Exception], message: str) -> None:
    node = world.node("n")
    with pytest.raises(error, match=message):
        node.create_publisher(String, "t", qos)
    with pytest.raises(error, match=message):
        node.create_subscription(String, "t", print, qos)


@pytest.mark.parametrize("kind", ["history", "reliability", "durability", "liveliness"])
def test_no_endpoint_can_have_an_unknown_policy(world: Any, kind: str) -> None:
    node = world.node("n")
    unknown = QoSProfile(depth=1, **{kind: 4 if kind == "liveliness" else 3})
    with pytest.raises(RuntimeError, match="Failed to create publisher: Unknown QoS"):
        node.create_publisher(String, "t", unknown)
    with pytest.raises(RuntimeError, match="Failed to create subscription: Unknown QoS"):
        node.create_subscription(String, "t", print, unknown)


@pytest.mark.parametrize("depth", [1, 3])
def test_a_depth_keeps_so_many_messages(world: Any, depth: int) -> None:
    node = world.node("n")
    heard: list[int] = []
    node.create_subscription(Int32, "t", lambda message: heard.append(message.data), depth)
    publisher = node.create_publisher(Int32, "t", 10)
    for number in range(5):
        publisher.publish(Int32(data=number))
    world.settle()
    assert heard == list(range(5))[-depth:]


def test_endpoints_know_their_topic_type_and_qos(world: Any) -> None:
    node = world.node("n", namespace="lab")
    qos = QoSProfile(depth=3)
    publisher = node.create_publisher(String, "t", qos)
    subscription = node.create_subscription(String, "~/t", print, 4)
    service = node.create_service(Trigger, "s", serve)
    client = node.create_client(Trigger, "/s")
    assert (publisher.topic, publisher.topic_name, publisher.msg_type) == ("t", "/lab/t", String)
    assert (subscription.topic, subscription.topic_name, subscription.msg_type) == ("~/t", "/lab/n/t", String)
    assert publisher.qos_profile == qos
    assert subscription.qos_profile == QoSProfile(depth=4)
    assert (service.srv_name, service.service_name, service.srv_type) == ("s", "/lab/s", Trigger)
    assert (client.srv_name, client.service_name, client.srv_type) == ("/s", "/s", Trigger)
    for endpoint in (publisher, subscription, service, client):
        assert endpoint.logger_name == "lab.n"
    assert publisher in node.publishers
    assert list(node.subscriptions) == [subscription]
    assert list(node.clients) == [client]
    assert service in node.services


def test_both_sides_count_each_other(world: Any) -> None:
    node = world.node("n")
    publisher = node.create_publisher(String, "t", 1)
    subscriptions = [node.create_subscription(String, "t", print, 1) for _ in range(2)]
    node.create_publisher(String, "other", 1)
    world.settle()
    assert publisher.get_subscription_count() == 2
    assert [each.get_publisher_count() for each in subscriptions] == [1, 1]
    node.destroy_subscription(subscriptions[0])
    world.settle()
    assert publisher.get_subscription_count() == 1
    node.destroy_publisher(publisher)
    world.settle()
    assert subscriptions[1].get_publisher_count() == 0


def test_a_destroyed_publisher_is_gone(world: Any) -> None:
    node = world.node("n")
    publisher = node.create_publisher(String, "t", 1)
    assert node.destroy_publisher(publisher)
    world.settle()
    assert node.count_publishers("t") == 0
    assert publisher not in node.publishers
    assert not node.destroy_publisher(publisher)
    for use in (lambda: publisher.publish(String()), publisher.get_subscription_count, lambda: publisher.topic_name):
        with pytest.raises(InvalidHandle):
            use()


def test_a_destroyed_subscription_hears_nothing(world: Any) -> None:
    node = world.node("n")
    heard: list[Any] = []
    subscription = node.create_subscription(String, "t", heard.append, 10)
    publisher = node.create_publisher(String, "t", 10)
    publisher.publish(String())
    assert node.destroy_subscription(subscription)
    publisher.publish(String())
    world.settle()
    assert heard == []
    assert node.count_subscribers("t") == 0
    assert list(node.subscriptions) == []
    assert not node.destroy_subscription(subscription)
    with pytest.raises(InvalidHandle):
        subscription.get_publisher_count()


def test_a_destroyed_service_answers_nothing(world: Any) -> None:
    node = world.node("n")
    asked: list[Any] = []
    service = node.create_service(Trigger, "s", lambda request, response: asked.append(request) or response)
    client = node.create_client(Trigger, "s")
    world.settle()
    assert client.service_is_ready()
    future = client.call_async(Trigger.Request())
    assert node.destroy_service(service)
    world.settle()
    assert not future.done()
    assert asked == []
    assert not client.service_is_ready()
    assert node.count_services("s") == 0
    assert service not in node.services
    assert not node.destroy_service(service)
    with pytest.raises(InvalidHandle):
        service.service_name  # noqa: B018


def test_a_destroyed_client_asks_nothing(world: Any) -> None:
    node = world.node("n")
    node.create_service(Trigger, "s", serve)
    client = node.create_client(Trigger, "s")
    assert node.destroy_client(client)
    world.settle()
    assert node.count_clients("s") == 0
    assert list(node.clients) == []
    assert not node.destroy_client(client)
    for use in (lambda: client.call_async(Trigger.Request()), client.service_is_ready, lambda: client.service_name):
        with pytest.raises(InvalidHandle):
            use()


def test_endpoints_are_destroyed_at_the_end_of_with(world: Any) -> None:
    node = world.node("n")
    with (
        node.create_publisher(String, "t", 1),
        node.create_subscription(String, "t", print, 1),
        node.create_service(Trigger, "s", serve),
        node.create_client(Trigger, "s"),
    ):
        assert node.count_publishers("t") == 1
    world.settle()
    counts = [
        node.count_publishers("t"),
        node.count_subscribers("t"),
        node.count_services("s"),
        node.count_clients("s"),
    ]
    assert counts == [0, 0, 0, 0]


def test_a_node_is_destroyed_at_the_end_of_with(world: Any) -> None:
    from rclpy.node import Node

    keeper = world.node("keeper")
    with Node("n", context=world.context) as node:
        node.create_publisher(String, "t", 1)
        node.create_service(Trigger, "s", serve)
        world.settle()
        assert (keeper.count_publishers("t"), keeper.count_services("s")) == (1, 1)
    world.settle()
    assert (keeper.count_publishers("t"), keeper.count_services("s")) == (0, 0)
    assert keeper.get_node_names() == ["keeper"]


@pytest.mark.parametrize("wrong", [Trigger, Fibonacci])
def test_a_service_or_an_action_is_no_message(world: Any, wrong: Any) -> None:
    for use in (lambda: world.node("n").create_publisher(wrong, "t", 1), lambda: check_is_valid_msg_type(wrong)):
        with pytest.raises(RuntimeError, match="The message type provided is not valid"):
            use()


@pytest.mark.parametrize("wrong", [String, Fibonacci])
def test_a_message_or_an_action_is_no_service(world: Any, wrong: Any) -> None:
    for use in (lambda: world.node("n").create_client(wrong, "t"), lambda: check_is_valid_srv_type(wrong)):
        with pytest.raises(RuntimeError, match="The service type provided is not valid"):
            use()


def test_a_class_of_a_program_is_no_type_at_all(world: Any) -> None:
    node = world.node("n")
    for use in (
        lambda: node.create_publisher(int, "t", 1),
        lambda: node.create_service(int, "t", serve),
        lambda: check_for_type_support(int),
    ):
        with pytest.raises(AttributeError, match="This might be a ROS 1 message type but it should be a ROS 2 message"):
            use()
    check_is_valid_msg_type(String)
    check_is_valid_srv_type(Trigger)
    check_for_type_support(Fibonacci)


def test_a_publisher_waits_for_nobody(world: Any) -> None:
    publisher = world.node("n").create_publisher(String, "t", 1)
    assert publisher.wait_for_all_acked()
    assert publisher.wait_for_all_acked(Duration(seconds=1))
    publisher.assert_liveliness()
    with pytest.raises(AttributeError):
        publisher.wait_for_all_acked(5)


# services


def test_every_client_gets_its_own_answer(world: Any) -> None:
    node = world.node("n")

    def answer(request: Any, response: Any) -> Any:
        response.success, response.message = request.data, f"asked {request.data}"
        return response

    node.create_service(SetBool, "s", answer)
    clients = [node.create_client(SetBool, "s") for _ in range(2)]
    world.settle()
    futures = [clients[index % 2].call_async(SetBool.Request(data=index > 1)) for index in range(4)]
    world.settle()
    assert [(each.result().success, each.result().message) for each in futures] == [
        (False, "asked False"),
        (False, "asked False"),
        (True, "asked True"),
        (True, "asked True"),
    ]


def test_a_coroutine_may_answer(world: Any) -> None:
    node = world.node("n")

    async def answer(_request: Any, response: Any) -> Any:
        response.success = True
        return response

    node.create_service(Trigger, "s", answer)
    client = node.create_client(Trigger, "s")
    world.settle()
    assert world.until(client.call_async(Trigger.Request())).success


def test_requests_and_responses_have_the_types_of_the_service(world: Any) -> None:
    node = world.node("n")
    node.create_service(Trigger, "s", lambda _request, _response: "wrong")
    client = node.create_client(Trigger, "s")
    for wrong in (SetBool.Request(), "text", None, Trigger.Response()):
        with pytest.raises(TypeError):
            client.call_async(wrong)
        with pytest.raises(TypeError):
            client.call(wrong)
    world.settle()
    client.call_async(Trigger.Request())
    with pytest.raises(TypeError):
        world.settle()


def test_a_request_is_pending_until_its_answer_is_there(world: Any) -> None:
    node = world.node("n")
    node.create_service(Trigger, "s", serve)
    client = node.create_client(Trigger, "s")
    world.settle()
    futures = [client.call_async(Trigger.Request()) for _ in range(2)]
    assert [client.get_pending_request(number) for number in (1, 2)] == futures
    client.remove_pending_request(futures[0])
    with pytest.raises(KeyError):
        client.get_pending_request(1)
    world.settle()
    assert [future.done() for future in futures] == [False, True]
    with pytest.raises(KeyError):
        client.get_pending_request(2)


def test_a_service_is_waited_for(world: Any) -> None:
    node = world.node("n")
    client = node.create_client(Trigger, "s")
    assert not client.wait_for_service(0)
    assert not client.wait_for_service(0.01)
    thread = Thread(target=lambda: node.create_service(Trigger, "s", serve))
    thread.start()
    assert client.wait_for_service(5)
    assert client.wait_for_service()
    thread.join()


def test_a_wait_for_a_service_lasts_until_the_service_comes(world: Any, monkeypatch: pytest.MonkeyPatch) -> None:
    node = world.node("n")
    client = node.create_client(Trigger, "s")
    listening = Event()
    listen = world.graph.add_listener
    monkeypatch.setattr(world.graph, "add_listener", lambda heard: listening.set() or listen(heard))
    found: list[bool] = []
    thread = Thread(target=lambda: found.append(client.wait_for_service(30)), daemon=True)
    thread.start()
    until(lambda: listening.is_set() or not thread.is_alive())
    assert found == []
    node.create_service(Trigger, "s", serve)
    thread.join(30)
    assert found == [True]


def test_a_call_blocks_until_another_thread_has_the_answer(world: Any) -> None:
    node = world.node("n")
    node.create_service(Trigger, "s", lambda _, response: setattr(response, "message", "yes") or response)
    client = node.create_client(Trigger, "s")
    world.settle()
    answers: list[Any] = []
    thread = Thread(target=lambda: answers.append(client.call(Trigger.Request(), timeout_sec=10)), daemon=True)
    thread.start()
    for _ in range(10_000):
        world.settle()
        thread.join(0.001)
        if not thread.is_alive():
            break
    assert [each.message for each in answers] == ["yes"]
    with pytest.raises(TimeoutError):
        client.call(Trigger.Request(), timeout_sec=0.01)


@pytest.mark.parametrize(
    ("state", "kinds", "contents"),
    [
        (ServiceIntrospectionState.OFF, [], 0),
        (ServiceIntrospectionState.METADATA, [0, 1, 2, 3], 0),
        (ServiceIntrospectionState.CONTENTS, [0, 1, 2, 3], 4),
    ],
)
def test_services_and_clients_tell_of_their_calls(
    world: Any, state: ServiceIntrospectionState, kinds: list[int], contents: int
) -> None:
    node = world.node("n")
    service = node.create_service(SetBool, "s", lambda _, response: setattr(response, "message", "done") or response)
    client = node.create_client(SetBool, "s")
    events: list[Any] = []
    node.create_subscription(SetBool.Event, "s/_service_event", events.append, 10)
    for each in (service, client):
        each.configure_introspection(node.get_clock(), QoSProfile(depth=10), state)
    world.settle()
    world.until(client.call_async(SetBool.Request(data=True)))
    world.settle()
    events.sort(key=lambda event: event.info.event_type)
    assert [event.info.event_type for event in events] == kinds
    assert sum(len(event.request) + len(event.response) for event in events) == contents
    assert {event.info.sequence_number for event in events} == ({1} if kinds else set())
    assert len({bytes(event.info.client_gid) for event in events}) == bool(kinds)
    if contents:
        assert [len(event.request) for event in events] == [1, 1, 0, 0]
        assert events[0].request[0].data is True
        assert events[3].response[0].message == "done"
    for each in (service, client):
        each.configure_introspection(node.get_clock(), QoSProfile(depth=10), ServiceIntrospectionState.OFF)
    events.clear()
    world.until(client.call_async(SetBool.Request()))
    world.settle()
    assert events == []


# bytes, and one message


def test_a_message_becomes_bytes_and_comes_back() -> None:
    data = serialize_message(Int32(data=-5))
    assert data == bytes.fromhex("00010000fbffffff")
    assert deserialize_message(data, Int32) == Int32(data=-5)


@pytest.mark.parametrize(
    ("use", "error", "message"),
    [
        (lambda: serialize_message(String), AttributeError, "has no attribute '_TYPE_SUPPORT'"),
        (lambda: serialize_message("text"), AttributeError, "This might be a ROS 1 message type"),
        (lambda: deserialize_message(b"", int), AttributeError, "This might be a ROS 1 message type"),
        (lambda: deserialize_message("text", String), TypeError, r"rclpy_deserialize\(\): incompatible function arg"),  # type: ignore[arg-type]
        (
            lambda: deserialize_message(bytes.fromhex("00010000ff000000"), String),
            RuntimeError,
            "Fast CDR exception deserializing message of type std_msgs::msg::dds_::String_.",
        ),
    ],
)
def test_what_is_no_message_has_no_bytes(use: Any, error: type[Exception], message: str) -> None:
    with pytest.raises(error, match=message):
        use()


def test_one_message_is_waited_for(world: Any) -> None:
    node = world.node("n")
    latched = QoSProfile(depth=1, durability=DurabilityPolicy.TRANSIENT_LOCAL)
    assert wait_for_message(String, node, "t", time_to_wait=0.01) == (False, None)
    node.create_publisher(String, "t", latched).publish(String(data="kept"))
    assert wait_for_message(String, node, "t", qos_profile=latched, time_to_wait=5) == (True, String(data="kept"))
    assert node.count_subscribers("t") == 0


def test_a_message_that_comes_later_is_waited_for(world: Any) -> None:
    node = world.node("n")
    publisher = world.node("other").create_publisher(Int32, "t", 1)
    found: list[Any] = []
    thread = Thread(target=lambda: found.append(wait_for_message(Int32, node, "t", time_to_wait=10)), daemon=True)
    thread.start()
    for _ in range(10_000):
        publisher.publish(Int32(data=7))
        thread.join(0.001)
        if not thread.is_alive():
            break
    assert found == [(True, Int32(data=7))]


def test_a_publisher_class_that_fails_leaves_nothing_behind(world: Any) -> None:
    from rclpy.publisher import Publisher

    class Broken(Publisher[Any]):
        def __init__(self, *_: Any) -> None:
            raise ValueError("broken")

    node = world.node("n")
    with pytest.raises(ValueError, match="broken"):
        node.create_publisher(String, "t", 1, publisher_class=Broken)
    world.settle()
    assert node.count_publishers("t") == 0
    assert isinstance(node.create_publisher(String, "t", 1, publisher_class=Publisher), Publisher)
