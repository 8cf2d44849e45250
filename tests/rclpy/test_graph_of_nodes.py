"""What a node sees of the graph, and the names it resolves: who is there, who publishes what, counts, endpoints, checks."""

from __future__ import annotations

import re
from collections.abc import Callable
from threading import Timer
from typing import Any

import pytest
from std_msgs.msg import Int32, String
from std_srvs.srv import SetBool, Trigger

from rclpy.duration import Duration
from rclpy.exceptions import (
    InvalidHandle,
    InvalidNamespaceException,
    InvalidNodeNameException,
    InvalidParameterException,
    InvalidServiceNameException,
    InvalidTopicNameException,
    NameValidationException,
)
from rclpy.expand_topic_name import expand_topic_name
from rclpy.qos import DurabilityPolicy, HistoryPolicy, LivelinessPolicy, QoSProfile, ReliabilityPolicy
from rclpy.topic_endpoint_info import TopicEndpointInfo, TopicEndpointTypeEnum
from rclpy.topic_or_service_is_hidden import topic_or_service_is_hidden
from rclpy.type_hash import TypeHash
from rclpy.validate_full_topic_name import validate_full_topic_name
from rclpy.validate_namespace import validate_namespace
from rclpy.validate_node_name import validate_node_name
from rclpy.validate_parameter_name import validate_parameter_name
from rclpy.validate_topic_name import validate_topic_name

OWN = ("/rosout", "/parameter_events")


@pytest.fixture
def two(world: Any) -> tuple[Any, Any]:
    """A node `one`, and `/lab/two` which publishes, listens, serves and asks."""
    one, two = world.node("one"), world.node("two", namespace="lab")
    two.create_publisher(String, "words", 1)
    two.create_publisher(String, "/shared", 1)
    two.create_subscription(Int32, "numbers", lambda _: None, 1)
    two.create_service(Trigger, "serve", lambda _, response: response)
    two.create_client(SetBool, "ask")
    world.settle()
    return one, two


def test_nodes_are_known_by_name_namespace_and_enclave(two: tuple[Any, Any]) -> None:
    one, _ = two
    assert sorted(one.get_node_names()) == ["one", "two"]
    assert sorted(one.get_fully_qualified_node_names()) == ["/lab/two", "/one"]
    assert sorted(one.get_node_names_and_namespaces()) == [("one", "/"), ("two", "/lab")]
    assert sorted(one.get_node_names_and_namespaces_with_enclaves()) == [("one", "/", "/"), ("two", "/lab", "/")]
    assert [each.get_fully_qualified_name() for each in two] == ["/one", "/lab/two"]


def test_topics_and_services_have_their_types(two: tuple[Any, Any]) -> None:
    one, _ = two
    topics = dict(one.get_topic_names_and_types())
    assert {name: types for name, types in topics.items() if name not in OWN} == {
        "/lab/words": ["std_msgs/msg/String"],
        "/shared": ["std_msgs/msg/String"],
        "/lab/numbers": ["std_msgs/msg/Int32"],
    }
    services = dict(one.get_service_names_and_types())
    assert services["/lab/serve"] == ["std_srvs/srv/Trigger"]
    assert services["/lab/ask"] == ["std_srvs/srv/SetBool"]


def test_each_node_is_known_by_what_it_does(two: tuple[Any, Any]) -> None:
    one, _ = two
    published = [each for each in one.get_publisher_names_and_types_by_node("two", "/lab") if each[0] not in OWN]
    assert published == [("/lab/words", ["std_msgs/msg/String"]), ("/shared", ["std_msgs/msg/String"])]
    assert one.get_subscriber_names_and_types_by_node("two", "/lab") == [("/lab/numbers", ["std_msgs/msg/Int32"])]
    assert ("/lab/serve", ["std_srvs/srv/Trigger"]) in one.get_service_names_and_types_by_node("two", "/lab")
    assert one.get_client_names_and_types_by_node("two", "/lab") == [("/lab/ask", ["std_srvs/srv/SetBool"])]
    assert one.get_subscriber_names_and_types_by_node("one", "") == []
    assert one.get_client_names_and_types_by_node("one", "/") == []


def test_the_middleware_has_other_names(two: tuple[Any, Any]) -> None:
    one, _ = two
    topics = dict(one.get_topic_names_and_types(no_demangle=True))
    assert topics["rt/lab/words"] == ["std_msgs::msg::dds_::String_"]
    assert topics["rq/lab/serveRequest"] == ["std_srvs::srv::dds_::Trigger_Request_"]
    assert topics["rr/lab/serveReply"] == ["std_srvs::srv::dds_::Trigger_Response_"]
    assert topics["ros_discovery_info"] == ["rmw_dds_common::msg::dds_::ParticipantEntitiesInfo_"]
    published = dict(one.get_publisher_names_and_types_by_node("two", "/lab", no_demangle=True))
    heard = dict(one.get_subscriber_names_and_types_by_node("two", "/lab", no_demangle=True))
    assert published["rt/lab/words"] == ["std_msgs::msg::dds_::String_"]
    assert published["rr/lab/serveReply"] == ["std_srvs::srv::dds_::Trigger_Response_"]
    assert published["rq/lab/askRequest"] == ["std_srvs::srv::dds_::SetBool_Request_"]
    assert heard["rt/lab/numbers"] == ["std_msgs::msg::dds_::Int32_"]
    assert heard["rq/lab/serveRequest"] == ["std_srvs::srv::dds_::Trigger_Request_"]
    assert heard["rr/lab/askReply"] == ["std_srvs::srv::dds_::SetBool_Response_"]
    assert "rr/lab/serveReply" not in heard
    assert "rq/lab/serveRequest" not in published


@pytest.mark.parametrize(
    "method",
    [
        "get_publisher_names_and_types_by_node",
        "get_subscriber_names_and_types_by_node",
        "get_service_names_and_types_by_node",
        "get_client_names_and_types_by_node",
    ],
)
def test_a_node_that_is_not_there_is_told(world: Any, method: str) -> None:
    ask = getattr(world.node("one"), method)
    with pytest.raises(RuntimeError, match=r"cannot get .* names and types for nonexistent node"):
        ask("nobody", "/")
    with pytest.raises(RuntimeError, match=r"cannot get .* names and types for nonexistent node"):
        ask("one", "/lab")
    with pytest.raises(RuntimeError, match="node name must not contain characters other than alphanumerics or '_'"):
        ask("a b", "/")
    with pytest.raises(RuntimeError, match="namespace must be absolute, it must lead with a '/'"):
        ask("one", "lab")


def test_endpoints_are_counted(two: tuple[Any, Any]) -> None:
    one, other = two

    def counts(node: Any, name: str) -> list[int]:
        counting = (node.count_publishers, node.count_subscribers, node.count_clients, node.count_services)
        return [count(name) for count in counting]

    assert counts(one, "/lab/words") == counts(other, "words") == [1, 0, 0, 0]
    assert counts(one, "/lab/numbers") == [0, 1, 0, 0]
    assert counts(one, "/lab/ask") == [0, 0, 1, 0]
    assert counts(one, "/lab/serve") == [0, 0, 0, 1]
    assert counts(one, "words") == [0, 0, 0, 0]
    assert counts(one, "/rosout")[0] == 2
    for count in (one.count_publishers, one.count_subscribers):
        with pytest.raises(ValueError, match=r"topic name .* is invalid"):
            count("a b")


def test_the_endpoints_of_a_topic_are_described(world: Any) -> None:
    one, two = world.node("one"), world.node("two", namespace="/lab")
    offered = QoSProfile(
        depth=7,
        reliability=ReliabilityPolicy.BEST_EFFORT,
        durability=DurabilityPolicy.TRANSIENT_LOCAL,
        deadline=Duration(seconds=1),
        lifespan=Duration(seconds=2),
        liveliness=LivelinessPolicy.MANUAL_BY_TOPIC,
        liveliness_lease_duration=Duration(seconds=3),
    )
    two.create_publisher(String, "/words", offered)
    one.create_subscription(String, "words", lambda _: None, 3)
    world.settle()
    (publisher,) = one.get_publishers_info_by_topic("words")
    (subscription,) = two.get_subscriptions_info_by_topic("/words")
    assert (publisher.node_name, publisher.node_namespace) == ("two", "/lab")
    assert (subscription.node_name, subscription.node_namespace) == ("one", "/")
    assert publisher.endpoint_type == TopicEndpointTypeEnum.PUBLISHER
    assert subscription.endpoint_type == TopicEndpointTypeEnum.SUBSCRIPTION
    assert publisher.topic_type == subscription.topic_type == "std_msgs/msg/String"
    assert len(publisher.endpoint_gid) == len(subscription.endpoint_gid) == 16
    assert publisher.endpoint_gid != subscription.endpoint_gid
    assert re.fullmatch("RIHS01_[0-9a-f]{64}", str(publisher.topic_type_hash))
    assert publisher.topic_type_hash == subscription.topic_type_hash
    qos = publisher.qos_profile
    assert (qos.history, qos.depth) == (HistoryPolicy.UNKNOWN, 0), "discovery does not tell them"
    assert (qos.reliability, qos.durability) == (offered.reliability, offered.durability)
    assert (qos.deadline, qos.lifespan) == (offered.deadline, offered.lifespan)
    assert qos.liveliness == offered.liveliness
    assert qos.liveliness_lease_duration == offered.liveliness_lease_duration
    assert subscription.qos_profile.deadline.nanoseconds == 2**63 - 1
    assert subscription.qos_profile.reliability == ReliabilityPolicy.RELIABLE
    (mangled,) = one.get_publishers_info_by_topic("rt/words", no_mangle=True)
    assert mangled.topic_type == "std_msgs::msg::dds_::String_"
    assert one.get_publishers_info_by_topic("/words", no_mangle=True) == []


def test_an_endpoint_is_shown_line_by_line() -> None:
    info = TopicEndpointInfo(
        node_name="n",
        node_namespace="/lab",
        topic_type="std_msgs/msg/String",
        topic_type_hash=TypeHash(1, bytes(range(32))),
        endpoint_type=1,
        endpoint_gid=[1, 255],
        qos_profile=QoSProfile(depth=3),
    )
    assert str(info).splitlines() == [
        "Node name: n",
        "Node namespace: /lab",
        "Topic type: std_msgs/msg/String",
        f"Topic type hash: RIHS01_{bytes(range(32)).hex()}",
        "Endpoint type: PUBLISHER",
        "GID: 01.ff",
        "QoS profile:",
        "  Reliability: RELIABLE",
        "  History (Depth): KEEP_LAST (3)",
        "  Durability: VOLATILE",
        "  Lifespan: 0 nanoseconds",
        "  Deadline: 0 nanoseconds",
        "  Liveliness: SYSTEM_DEFAULT",
        "  Liveliness lease duration: 0 nanoseconds",
    ]
    info.qos_profile = QoSProfile(history=HistoryPolicy.KEEP_ALL)
    assert "  History (Depth): KEEP_ALL\n" in str(info)


def test_an_endpoints_description_is_checked() -> None:
    empty = TopicEndpointInfo()
    assert (empty.node_name, empty.endpoint_gid, empty.endpoint_type) == ("", [], TopicEndpointTypeEnum.INVALID)
    assert str(empty.topic_type_hash) == "INVALID"
    assert empty == TopicEndpointInfo()
    assert empty != TopicEndpointInfo(node_name="n")
    assert empty != 5
    given = TopicEndpointInfo(
        qos_profile={"depth": 4}, topic_type_hash={"version": 1, "value": bytes(32)}, endpoint_type=2
    )
    assert given.qos_profile == QoSProfile(depth=4)
    assert given.topic_type_hash == TypeHash(1, bytes(32))
    assert given.endpoint_type is TopicEndpointTypeEnum.SUBSCRIPTION
    for wrong in (
        {"node_name": 1},
        {"node_namespace": 1},
        {"topic_type": 1},
        {"topic_type_hash": "x"},
        {"endpoint_type": "x"},
        {"endpoint_gid": ["x"]},
        {"qos_profile": 5},
    ):
        with pytest.raises(AssertionError):
            TopicEndpointInfo(**wrong)  # type: ignore[arg-type]


def test_a_type_hash_is_a_version_and_32_bytes() -> None:
    assert str(TypeHash()) == "INVALID"
    assert str(TypeHash(12, bytes(32))) == "RIHS12_" + "00" * 32
    assert TypeHash(1) != TypeHash(2)
    assert TypeHash(1, bytes(32)) != TypeHash(1, bytes([1] * 32))
    assert TypeHash() != 5
    for wrong in ({"version": "1"}, {"value": "x"}):
        with pytest.raises(AssertionError):
            TypeHash(**wrong)  # type: ignore[arg-type]


def test_a_node_is_waited_for(world: Any) -> None:
    node = world.node("one")
    assert node.wait_for_node("/one", 1.0)
    assert node.wait_for_node("one", 1.0)
    assert not node.wait_for_node("/nobody", 0.01)
    late = Timer(0.05, world.node, ["late"])
    late.start()
    assert node.wait_for_node("/late", 5.0)
    late.join()


@pytest.mark.parametrize(
    "use",
    [
        lambda node: node.get_node_names(),
        lambda node: node.get_topic_names_and_types(),
        lambda node: node.get_service_names_and_types(),
        lambda node: node.count_publishers("x"),
        lambda node: node.get_publishers_info_by_topic("x"),
        lambda node: node.get_fully_qualified_name(),
        lambda node: node.resolve_topic_name("x"),
        lambda node: node.create_publisher(String, "x", 1),
        lambda node: node.create_subscription(String, "x", print, 1),
        lambda node: node.create_service(Trigger, "x", print),
        lambda node: node.create_client(Trigger, "x"),
        lambda node: node.get_namespace(),
    ],
)
def test_a_destroyed_node_sees_nothing(world: Any, use: Callable[[Any], Any]) -> None:
    node = world.node("one")
    node.destroy_node()
    with pytest.raises(InvalidHandle):
        use(node)


@pytest.mark.parametrize(
    "use",
    [
        lambda node: node.get_node_names(),
        lambda node: node.get_topic_names_and_types(),
        lambda node: node.get_service_names_and_types(),
        lambda node: node.get_publisher_names_and_types_by_node("one", "/"),
        lambda node: node.count_publishers("x"),
        lambda node: node.get_subscriptions_info_by_topic("x"),
        lambda node: node.create_publisher(String, "x", 1),
        lambda node: node.create_client(Trigger, "x"),
        lambda node: node.create_guard_condition(lambda: None),
    ],
)
def test_a_node_sees_nothing_after_the_shutdown(world: Any, use: Callable[[Any], Any]) -> None:
    from rclpy.node import Node

    node = Node("one", context=world.context)
    world.context.shutdown()
    with pytest.raises(RuntimeError):
        use(node)


# names


@pytest.mark.parametrize(
    ("name", "topic"),
    [
        ("chatter", "/lab/chatter"),
        ("/chatter", "/chatter"),
        ("~", "/lab/two"),
        ("~/chatter", "/lab/two/chatter"),
        ("{node}/x", "/lab/two/x"),
        ("{ns}/x", "/lab/x"),
        ("/a/{namespace}", None),
        ("a/b", "/lab/a/b"),
    ],
)
def test_a_name_becomes_a_full_one(world: Any, name: str, topic: str | None) -> None:
    node = world.node("two", namespace="lab")
    if topic is None:
        with pytest.raises(RuntimeError):
            node.resolve_topic_name(name)
        return
    assert node.resolve_topic_name(name) == node.resolve_service_name(name) == topic
    assert expand_topic_name(name, "two", "/lab") == topic


WRONG = [
    ("", "topic name must not be empty", 0),
    ("a b", "topic name must not contain characters other than alphanumerics, '_', '~', '{', or '}'", 1),
    ("a/", "topic name must not end with a forward slash", 1),
    ("1a", "topic name token must not start with a number", 0),
    ("~ab", "topic name must not have a tilde '~' that is not followed by a forward slash '/'", 1),
    ("{a", "topic name must not have unmatched (unbalanced) curly braces '{}'", 0),
]


@pytest.mark.parametrize(("name", "message", "place"), WRONG)
def test_a_wrong_name_is_shown_with_a_caret(world: Any, name: str, message: str, place: int) -> None:
    node = world.node("n")
    for make, error, word in (
        (lambda: node.create_publisher(String, name, 1), InvalidTopicNameException, "topic"),
        (lambda: node.create_subscription(String, name, print, 1), InvalidTopicNameException, "topic"),
        (lambda: node.create_service(Trigger, name, print), InvalidServiceNameException, "service"),
        (lambda: node.create_client(Trigger, name), InvalidServiceNameException, "service"),
    ):
        with pytest.raises(error) as caught:
            make()
        assert str(caught.value).startswith(f"Invalid {word} name: {message}")
        assert str(caught.value).endswith(f"\n  '{name}'\n   {' ' * place}^")
    with pytest.raises(RuntimeError, match=re.escape(f"failed to resolve name: {message}")):
        node.resolve_topic_name(name)


def test_a_name_that_is_wrong_once_it_is_full_is_refused_too(world: Any) -> None:
    node = world.node("n")
    with pytest.raises(InvalidTopicNameException, match="must not contain repeated '/'"):
        node.create_publisher(String, "a//b", 1)
    with pytest.raises(InvalidServiceNameException, match="must not contain repeated '/'"):
        node.create_client(Trigger, "a//b")
    with pytest.raises((ValueError, RuntimeError), match="unknown substitution"):
        node.create_publisher(String, "{who}/b", 1)
    rules = ["--ros-args", "-r", "a:=~/b", "-r", "c:=" + 300 * "c"]
    remapped = world.node("remapped", cli_args=rules, namespace="/ns")
    assert remapped.create_publisher(String, "a", 1).topic_name == "/ns/remapped/b"
    with pytest.raises(RuntimeError, match="topic length should not exceed '255U - 8U'"):
        remapped.create_publisher(String, "c", 1)


@pytest.mark.parametrize(
    ("check", "good", "wrong", "error", "message", "place"),
    [
        (validate_node_name, "my_node", "my node", InvalidNodeNameException, "node name must not contain", 2),
        (validate_namespace, "/my_ns", "/my ns", InvalidNamespaceException, "namespace must not contain", 3),
        (validate_topic_name, "~/{node}/x", "x y", InvalidTopicNameException, "topic name must not contain", 1),
        (validate_full_topic_name, "/x/y", "/x//y", InvalidTopicNameException, "topic name must not contain rep", 3),
        (
            lambda name: validate_topic_name(name, is_service=True),
            "x",
            "x?",
            InvalidServiceNameException,
            "topic name must not contain",
            1,
        ),
        (
            lambda name: validate_full_topic_name(name, is_service=True),
            "/x",
            "x",
            InvalidServiceNameException,
            "topic name must be absolute",
            0,
        ),
    ],
)
def test_names_are_validated(
    check: Any, good: str, wrong: str, error: type[Exception], message: str, place: int
) -> None:
    assert check(good) is True
    with pytest.raises(error) as caught:
        check(wrong)
    kind = {
        InvalidNodeNameException: "node name",
        InvalidNamespaceException: "namespace",
        InvalidTopicNameException: "topic name",
        InvalidServiceNameException: "service name",
    }[error]
    assert str(caught.value).startswith(f"Invalid {kind}: {message}")
    assert str(caught.value).endswith(f":\n  '{wrong}'\n   {' ' * place}^")
    assert isinstance(caught.value, NameValidationException)


def test_a_parameters_name_is_anything_but_empty() -> None:
    assert validate_parameter_name("any thing/at.all")
    with pytest.raises(InvalidParameterException, match=r"^Invalid parameter name: $"):
        validate_parameter_name("")


@pytest.mark.parametrize(
    ("arguments", "subject"),
    [
        (("a b", "n", "/"), "topic name 'a b' is invalid: topic name must not contain"),
        (("a", "n n", "/"), "node name 'n n' is invalid: node name must not contain"),
        (("a", "n", "ns"), "node namespace 'ns' is invalid: namespace must be absolute"),
        (("{x}", "n", "/"), "topic name '{x}' is invalid: unknown substitution: {x}"),
    ],
)
def test_only_good_names_are_expanded(arguments: tuple[str, str, str], subject: str) -> None:
    with pytest.raises(ValueError, match=re.escape(subject)):
        expand_topic_name(*arguments)


@pytest.mark.parametrize("arguments", [(1, "n", "/"), ("a", 1, "/"), ("a", "n", 5)])
def test_only_texts_are_expanded(arguments: Any) -> None:
    with pytest.raises(TypeError, match=r"rclpy_expand_topic_name\(\): incompatible function arguments"):
        expand_topic_name(*arguments)


@pytest.mark.parametrize(("name", "hidden"), [("/a/b", False), ("/_a/b", True), ("/a/_b", True), ("/a_/b", False)])
def test_an_underscore_hides_a_name(name: str, hidden: bool) -> None:
    assert topic_or_service_is_hidden(name) is hidden
