"""What was destroyed refuses to be used, whatever is asked of it; after a signal what needs the middleware says why not."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import pytest
from std_msgs.msg import String
from std_srvs.srv import Trigger

import rclpy
from rclpy.duration import Duration
from rclpy.exceptions import InvalidHandle
from rclpy.impl.implementation_singleton import rclpy_implementation as low_level
from rclpy.qos import QoSProfile, qos_profile_services_default
from rclpy.service_introspection import ServiceIntrospectionState

QOS = QoSProfile(depth=5).get_c_qos_profile()
DESTROYED = "cannot use Destroyable because destruction was requested"


def answer(_request: Any, response: Any) -> Any:
    return response


def introspect(endpoint: Any) -> None:
    state = ServiceIntrospectionState.METADATA
    endpoint.configure_introspection(rclpy.clock.Clock(), qos_profile_services_default, state)


def asked_by_hand(node: Any) -> Any:
    """Return a service's handle and the header of a request that it took."""
    service = low_level.Service(node.handle, Trigger, "by_hand", QOS)
    low_level.Client(node.handle, Trigger, "by_hand", QOS).send_request(Trigger.Request())
    service.header = service.service_take_request(Trigger.Request)[1].request_id
    return service


def asked(node: Any) -> Any:
    """Return a service with the header of a request that it may still answer."""
    service = node.create_service(Trigger, "s", answer)
    service.header = asked_by_hand(node).header
    return service


def clock_timer(node: Any) -> Any:
    return low_level.Timer(node.get_clock().handle, node.context.handle, 50, True)


NAMES = ("topic_name", "logger_name")
USES: dict[str, tuple[Callable[[Any], Any], tuple[str, ...], tuple[Callable[[Any], Any], ...]]] = {
    "publisher": (
        lambda node: node.create_publisher(String, "t", 1),
        ("get_subscription_count", "assert_liveliness", "wait_for_all_acked", *NAMES),
        (lambda publisher: publisher.publish(String()),),
    ),
    "subscription": (
        lambda node: node.create_subscription(String, "t", print, 1),
        ("get_publisher_count", "get_content_filter", "is_cft_enabled", *NAMES),
        (lambda subscription: subscription.set_content_filter("data = 'x'", []),),
    ),
    "service": (
        asked,
        ("service_name", "logger_name"),
        (lambda service: service.send_response(Trigger.Response(), service.header), introspect),
    ),
    "client": (
        lambda node: node.create_client(Trigger, "s"),
        ("service_is_ready", "service_name", "logger_name"),
        (
            lambda client: client.call_async(Trigger.Request()),
            lambda client: client.call(Trigger.Request(), timeout_sec=0.01),
            lambda client: client.wait_for_service(0),
            introspect,
        ),
    ),
    "timer": (
        lambda node: node.create_timer(1.0, print),
        (
            "timer_period_ns", "is_ready", "is_canceled", "cancel", "reset", "time_since_last_call",
            "time_until_next_call",
        ),
        (lambda timer: setattr(timer, "timer_period_ns", 5),),
    ),
    "guard condition": (lambda node: node.create_guard_condition(print), ("trigger",), ()),
    "publisher's handle": (
        lambda node: low_level.Publisher(node.handle, String, "t", QOS),
        ("get_subscription_count",),
        (
            lambda handle: handle.publish(String()),
            lambda handle: handle.wait_for_all_acked(Duration(seconds=1).get_c_duration()),
        ),
    ),
    "subscription's handle": (
        lambda node: low_level.Subscription(node.handle, String, "t", QOS),
        ("get_publisher_count", "is_cft_enabled", "get_content_filter"),
        (lambda handle: handle.set_content_filter("data = 'x'", []),),
    ),
    "service's handle": (
        asked_by_hand,
        (),
        (
            lambda handle: handle.service_take_request(Trigger.Request),
            lambda handle: handle.service_send_response(Trigger.Response(), handle.header),
        ),
    ),
    "client's handle": (
        lambda node: low_level.Client(node.handle, Trigger, "s", QOS),
        ("service_server_is_available",),
        (
            lambda handle: handle.send_request(Trigger.Request()),
            lambda handle: handle.take_response(Trigger.Response),
        ),
    ),
    "timer's handle": (
        clock_timer,
        (
            "call_timer", "call_timer_with_info", "is_timer_ready", "is_timer_canceled", "cancel_timer", "reset_timer",
            "get_timer_period", "time_since_last_call", "time_until_next_call",
        ),
        (lambda handle: handle.change_timer_period(3),),
    ),
    "guard condition's handle": (
        lambda node: low_level.GuardCondition(node.context.handle),
        ("trigger_guard_condition",),
        (),
    ),
}  # fmt: skip
IN_THE_GRAPH: tuple[tuple[str, Callable[[Any], Any]], ...] = (
    ("Failed to get node names", lambda node: node.get_node_names()),
    ("Failed to get node names", lambda node: node.get_fully_qualified_node_names()),
    ("Failed to get node names", lambda node: node.get_node_names_and_namespaces()),
    ("Failed to get node names", lambda node: node.get_node_names_and_namespaces_with_enclaves()),
    ("Failed to get node names", lambda node: node.wait_for_node("/n", 0.01)),
    ("Error in rcl_count_publishers", lambda node: node.count_publishers("t")),
    ("Error in rcl_count_subscribers", lambda node: node.count_subscribers("t")),
    ("Error in rcl_count_services", lambda node: node.count_services("s")),
    ("Error in rcl_count_clients", lambda node: node.count_clients("s")),
    ("failed to get topic names and types", lambda node: node.get_topic_names_and_types()),
    ("failed to get service names and types", lambda node: node.get_service_names_and_types()),
    ("failed to get publisher names and types", lambda node: node.get_publisher_names_and_types_by_node("n", "/")),
    ("failed to get subscriber names and types", lambda node: node.get_subscriber_names_and_types_by_node("n", "/")),
    ("failed to get service names and types", lambda node: node.get_service_names_and_types_by_node("n", "/")),
    ("failed to get client names and types", lambda node: node.get_client_names_and_types_by_node("n", "/")),
    ("Failed to get information by topic for publishers", lambda node: node.get_publishers_info_by_topic("/t")),
    ("Failed to get information by topic for subscriptions", lambda node: node.get_subscriptions_info_by_topic("/t")),
    ("Failed to create publisher", lambda node: node.create_publisher(String, "x", 1)),
    ("Failed to create subscription", lambda node: node.create_subscription(String, "x", print, 1)),
    ("failed to create client", lambda node: node.create_client(Trigger, "x")),
    ("failed to create service", lambda node: node.create_service(Trigger, "x", print)),
)
NAMED: tuple[Callable[[Any], Any], ...] = (
    lambda node: node.get_name(),
    lambda node: node.get_namespace(),
    lambda node: node.get_fully_qualified_name(),
    lambda node: node.resolve_topic_name("x"),
    lambda node: node.resolve_service_name("x"),
)


def value_of(thing: Any, name: str) -> Any:
    found = getattr(thing, name)
    return found() if callable(found) else found


@pytest.mark.parametrize("kind", USES)
def test_what_was_destroyed_refuses_every_use(world: Any, kind: str) -> None:
    make, names, uses = USES[kind]
    thing = make(world.node("n"))
    getattr(thing, "destroy", getattr(thing, "destroy_when_not_in_use", None))()
    for name in names:
        with pytest.raises(InvalidHandle, match=DESTROYED):
            value_of(thing, name)
    for use in uses:
        with pytest.raises(InvalidHandle, match=DESTROYED):
            use(thing)


def test_a_destroyed_node_refuses_every_use(world: Any) -> None:
    node = world.node("n")
    for use in NAMED:
        assert use(node)
    node.destroy_node()
    for use in (*NAMED, *(use for _, use in IN_THE_GRAPH), lambda node: node.declare_parameter("p", 1)):
        with pytest.raises(InvalidHandle, match=DESTROYED):
            use(node)
    assert node.get_parameter("use_sim_time").value is False


def test_after_a_signal_a_node_says_what_the_middleware_does_no_more(world: Any) -> None:
    node = world.node("n")
    world.interrupt()
    for told, use in IN_THE_GRAPH:
        with pytest.raises(
            RuntimeError, match=f"^{told}: rcl node's context is invalid, at /project/src/rcl/node.c:401$"
        ):
            use(node)
    for told, use in (
        ("failed to create timer", lambda: node.create_timer(1.0, print)),
        ("failed to create guard_condition", lambda: node.create_guard_condition(print)),
    ):
        with pytest.raises(RuntimeError, match=f"^{told}: the given context is not valid, either rcl_init"):
            use()
    assert [use(node) for use in NAMED] == ["n", "/", "/n", "/x", "/x"]


def test_after_a_signal_endpoints_say_what_the_middleware_does_no_more(world: Any) -> None:
    node = world.node("n")
    made = {kind: make(node) for kind, (make, _, _) in USES.items() if kind != "service's handle"}
    world.interrupt()
    publisher, by_hand, client = made["publisher"], made["publisher's handle"], made["client"]
    told: tuple[tuple[str, Callable[[], Any]], ...] = (
        ("Failed to publish", lambda: publisher.publish(String())),
        ("Failed to publish", lambda: by_hand.publish(String())),
        ("failed to get subscription count", publisher.get_subscription_count),
        ("failed to get subscription count", by_hand.get_subscription_count),
        ("Failed to assert liveliness on the Publisher", publisher.assert_liveliness),
        ("Failed to wait for all acknowledged", publisher.wait_for_all_acked),
        ("Failed to wait for all acknowledged", lambda: by_hand.wait_for_all_acked(Duration().get_c_duration())),
    )
    for words, use in told:
        with pytest.raises(RuntimeError, match=f"^{words}: publisher's context is invalid, at /project"):
            use()
    for use in (client.service_is_ready, lambda: client.wait_for_service(0)):
        with pytest.raises(RuntimeError, match=r"^failed to check service availability: rcl node's context is invalid"):
            use()
    assert (publisher.topic_name, client.service_name, publisher.logger_name) == ("/t", "/s", "n")
    assert made["subscription"].get_publisher_count() == 2
    assert not made["timer"].is_canceled()
    made["guard condition"].trigger()
