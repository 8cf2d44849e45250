"""Events of publishers and subscriptions, and content filters: who is told what, what is said by default, wrong filters."""

from __future__ import annotations

from typing import Any
from unittest.mock import Mock

import pytest
from std_msgs.msg import String
from test_msgs.msg import Arrays, BasicTypes, Nested, Strings

import rclpy.logging
from rclpy._day6.logging_settings import PROCESS
from rclpy.event_handler import (
    PublisherEventCallbacks,
    QoSPublisherEventType,
    QoSSubscriptionEventType,
    SubscriptionEventCallbacks,
    _warn,
)
from rclpy.qos import DurabilityPolicy, QoSProfile, ReliabilityPolicy
from rclpy.subscription_content_filter_options import ContentFilterOptions

BEST_EFFORT = QoSProfile(depth=1, reliability=ReliabilityPolicy.BEST_EFFORT)
LATCHED = QoSProfile(depth=1, durability=DurabilityPolicy.TRANSIENT_LOCAL)


def test_both_sides_are_told_who_comes_and_goes(world: Any) -> None:
    node = world.node("n")
    told: list[Any] = []

    def tell(side: str) -> Any:
        def callback(info: Any) -> None:
            told.append(
                (side, info.total_count, info.total_count_change, info.current_count, info.current_count_change)
            )

        return callback

    publisher = node.create_publisher(
        String, "t", 1, event_callbacks=PublisherEventCallbacks(matched=tell("publisher"))
    )
    world.settle()
    assert told == []
    subscription = node.create_subscription(
        String, "t", lambda _: None, 1, event_callbacks=SubscriptionEventCallbacks(matched=tell("subscription"))
    )
    world.settle()
    assert sorted(told) == [("publisher", 1, 1, 1, 1), ("subscription", 1, 1, 1, 1)]
    told.clear()
    node.destroy_subscription(subscription)
    world.settle()
    assert told == [("publisher", 1, 0, 0, -1)]
    told.clear()
    node.create_subscription(String, "t", lambda _: None, 1)
    world.settle()
    assert told == [("publisher", 2, 1, 1, 1)]
    told.clear()
    node.destroy_publisher(publisher)
    node.create_subscription(String, "t", lambda _: None, 1)
    world.settle()
    assert told == []


@pytest.mark.parametrize(
    ("offer", "wish", "policy"), [(BEST_EFFORT, QoSProfile(depth=1), 16), (QoSProfile(depth=1), LATCHED, 2)]
)
def test_both_sides_are_told_that_they_do_not_fit(world: Any, offer: QoSProfile, wish: QoSProfile, policy: int) -> None:
    node = world.node("n")
    told: list[Any] = []

    def tell(side: str) -> Any:
        return lambda info: told.append((side, info.total_count, info.total_count_change, int(info.last_policy_kind)))

    node.create_publisher(
        String, "t", offer, event_callbacks=PublisherEventCallbacks(incompatible_qos=tell("publisher"))
    )
    node.create_subscription(
        String,
        "t",
        lambda _: None,
        wish,
        event_callbacks=SubscriptionEventCallbacks(incompatible_qos=tell("subscription")),
    )
    world.settle()
    assert sorted(told) == [("publisher", 1, 1, policy), ("subscription", 1, 1, policy)]


def test_what_does_not_fit_is_logged_by_default(world: Any) -> None:
    node = world.node("n")
    node.create_publisher(String, "t", BEST_EFFORT)
    node.create_subscription(String, "~/t", lambda _: None, 1)
    world.settle()
    assert world.log == []
    node.create_subscription(String, "t", lambda _: None, 1)
    world.settle()
    world.settle()
    said = sorted(line.partition(" [n]: ")[2].rstrip() for line in world.log)
    end = "Last incompatible policy: RELIABILITY"
    assert said == [
        f"New publisher discovered on topic 't', offering incompatible QoS. No messages will be received from it. {end}",
        f"New subscription discovered on topic 't', requesting incompatible QoS. No messages will be sent to it. {end}",
    ]
    assert all(line.startswith("[WARN]") for line in world.log)


def test_a_logger_of_the_program_is_told_by_the_method_that_real_rclpy_calls(monkeypatch: pytest.MonkeyPatch) -> None:
    logger = Mock(spec=["get_child", "warn"])
    logger.get_child.return_value = logger
    monkeypatch.setattr(rclpy.logging, "_root_logger", logger)
    _warn(Mock(get_logger=lambda: Mock(_settings=PROCESS)), "text")
    logger.warn.assert_called_once_with("text")


def test_nothing_is_logged_where_the_program_does_not_want_it(world: Any) -> None:
    node = world.node("n")
    node.create_publisher(
        String, "t", BEST_EFFORT, event_callbacks=PublisherEventCallbacks(use_default_callbacks=False)
    )
    node.create_subscription(
        String, "t", lambda _: None, 1, event_callbacks=SubscriptionEventCallbacks(use_default_callbacks=False)
    )
    world.settle()
    assert world.log == []


def test_an_endpoint_has_a_handler_for_every_callback(world: Any) -> None:
    node = world.node("n")

    def nothing(_: Any) -> None:
        """Be called."""

    publisher = node.create_publisher(
        String,
        "t",
        1,
        event_callbacks=PublisherEventCallbacks(
            deadline=nothing, liveliness=nothing, incompatible_qos=nothing, incompatible_type=nothing, matched=nothing
        ),
    )
    subscription = node.create_subscription(
        String,
        "t",
        nothing,
        1,
        event_callbacks=SubscriptionEventCallbacks(
            deadline=nothing,
            liveliness=nothing,
            incompatible_qos=nothing,
            incompatible_type=nothing,
            matched=nothing,
            message_lost=nothing,
        ),
    )
    offered, requested = QoSPublisherEventType, QoSSubscriptionEventType
    assert {each.event_type for each in publisher.event_handlers} == {
        offered.RCL_PUBLISHER_OFFERED_DEADLINE_MISSED,
        offered.RCL_PUBLISHER_LIVELINESS_LOST,
        offered.RCL_PUBLISHER_OFFERED_INCOMPATIBLE_QOS,
        offered.RCL_PUBLISHER_INCOMPATIBLE_TYPE,
        offered.RCL_PUBLISHER_MATCHED,
    }
    assert {each.event_type for each in subscription.event_handlers} == {
        requested.RCL_SUBSCRIPTION_REQUESTED_DEADLINE_MISSED,
        requested.RCL_SUBSCRIPTION_LIVELINESS_CHANGED,
        requested.RCL_SUBSCRIPTION_REQUESTED_INCOMPATIBLE_QOS,
        requested.RCL_SUBSCRIPTION_MESSAGE_LOST,
        requested.RCL_SUBSCRIPTION_INCOMPATIBLE_TYPE,
        requested.RCL_SUBSCRIPTION_MATCHED,
    }
    assert all(each.callback is nothing for each in (*publisher.event_handlers, *subscription.event_handlers))
    assert publisher.event_handlers[0].get_num_entities().num_events == 1


def test_a_coroutine_may_be_told(world: Any) -> None:
    node = world.node("n")
    told: list[int] = []

    async def tell(info: Any) -> None:
        told.append(info.current_count)

    node.create_publisher(String, "t", 1, event_callbacks=PublisherEventCallbacks(matched=tell))
    node.create_subscription(String, "t", lambda _: None, 1)
    world.settle()
    assert told == [1]


@pytest.mark.parametrize(
    "name",
    [
        "QoSRequestedDeadlineMissedInfo",
        "QoSLivelinessChangedInfo",
        "QoSMessageLostInfo",
        "QoSRequestedIncompatibleQoSInfo",
        "QoSSubscriptionMatchedInfo",
        "QoSOfferedDeadlineMissedInfo",
        "QoSLivelinessLostInfo",
        "IncompatibleTypeInfo",
        "QoSOfferedIncompatibleQoSInfo",
        "QoSPublisherMatchedInfo",
    ],
)
def test_nothing_is_counted_before_anything_happens(name: str) -> None:
    from rclpy import event_handler

    info = getattr(event_handler, name)()
    counters = [each for each in dir(info) if "count" in each]
    assert counters
    assert {getattr(info, each) for each in counters} == {0}


# content filters

NUMBERS = [BasicTypes(int32_value=number, float64_value=number / 2, bool_value=number > 2) for number in range(5)]


@pytest.mark.parametrize(
    ("expression", "parameters", "expected"),
    [
        ("int32_value = 2", [], [2]),
        ("int32_value <> 2", [], [0, 1, 3, 4]),
        ("int32_value != 2", [], [0, 1, 3, 4]),
        ("int32_value < 2", [], [0, 1]),
        ("int32_value <= 2", [], [0, 1, 2]),
        ("int32_value > 2", [], [3, 4]),
        ("int32_value >= 2", [], [2, 3, 4]),
        ("2 < int32_value", [], [3, 4]),
        ("float64_value > 1.25", [], [3, 4]),
        ("float64_value = 1", [], [2]),
        ("bool_value = FALSE", [], [0, 1, 2]),
        ("bool_value = true", [], [3, 4]),
        ("int32_value between 1 and 3", [], [1, 2, 3]),
        ("int32_value BETWEEN %0 AND %1", ["2", "3"], [2, 3]),
        ("int32_value NOT BETWEEN 1 AND 3", [], [0, 4]),
        ("NOT int32_value = 2 AND NOT int32_value = 3", [], [0, 1, 4]),
        ("int32_value = 0 OR int32_value = 1 AND bool_value = TRUE", [], []),
        ("int32_value = 1 AND bool_value = TRUE OR int32_value = 0", [], [0]),
        ("(int32_value = 0 OR int32_value = 4) AND bool_value = TRUE", [], [4]),
        ("NOT (int32_value = 0 OR int32_value = 4)", [], [1, 2, 3]),
        ("int32_value = 0 OR int32_value = 2 OR int32_value = 4", [], [0, 2, 4]),
        ("int32_value > 0 AND int32_value < 4 AND float64_value <> 1", [], [1, 3]),
        ("int32_value > float64_value", [], [1, 2, 3, 4]),
    ],
)
def test_a_filter_lets_numbers_through(world: Any, expression: str, parameters: list[str], expected: list[int]) -> None:
    node = world.node("n")
    heard: list[int] = []
    options = ContentFilterOptions(expression, parameters)
    subscription = node.create_subscription(
        BasicTypes, "t", lambda message: heard.append(message.int32_value), 10, content_filter_options=options
    )
    publisher = node.create_publisher(BasicTypes, "t", 10)
    assert subscription.is_cft_enabled
    for message in NUMBERS:
        publisher.publish(message)
    world.settle()
    assert heard == expected


@pytest.mark.parametrize(
    ("expression", "parameters", "expected"),
    [
        ("string_value = 'bar'", [], ["bar"]),
        ("string_value = %0", ["'bar'"], ["bar"]),
        ("string_value > 'b'", [], ["bar", "foo", "f.o"]),
        ("string_value LIKE 'f%'", [], ["foo", "f.o"]),
        ("string_value LIKE 'f.o'", [], ["foo", "f.o"]),
        ("string_value LIKE 'f[.]o'", [], ["f.o"]),
        ("string_value like '_a_'", [], ["bar"]),
        ("NOT string_value LIKE '%o'", [], ["a", "bar"]),
    ],
)
def test_a_filter_lets_texts_through(world: Any, expression: str, parameters: list[str], expected: list[str]) -> None:
    node = world.node("n")
    heard: list[str] = []
    node.create_subscription(
        Strings,
        "t",
        lambda message: heard.append(message.string_value),
        10,
        content_filter_options=ContentFilterOptions(expression, parameters),
    )
    publisher = node.create_publisher(Strings, "t", 10)
    for text in ("a", "bar", "foo", "f.o"):
        publisher.publish(Strings(string_value=text))
    world.settle()
    assert heard == expected


@pytest.mark.parametrize(
    ("msg_type", "expression"),
    [(Nested, "basic_types_value.int32_value = 5"), (Arrays, "int32_values[1] = 5")],
)
def test_a_filter_looks_into_parts_of_a_message(world: Any, msg_type: Any, expression: str) -> None:
    node = world.node("n")
    heard: list[Any] = []
    options = ContentFilterOptions(expression, [])
    node.create_subscription(msg_type, "t", heard.append, 10, content_filter_options=options)
    publisher = node.create_publisher(msg_type, "t", 10)
    for number in (4, 5):
        message = msg_type()
        if msg_type is Nested:
            message.basic_types_value.int32_value = number
        else:
            message.int32_values[1] = number
        publisher.publish(message)
    world.settle()
    assert len(heard) == 1


@pytest.mark.parametrize(
    ("expression", "told"),
    [
        ("nothing = 1", "field 'nothing' not found"),
        ("int32_value", "expected"),
        ("int32_value =", "something is missing at the end"),
        ("= 1", "unexpected '='"),
        ("int32_value = 'text'", "the two sides of a comparison have different types"),
        ("1 = 1", "a comparison needs a field of the message"),
        ("int32_value = 1 AND", "something is missing at the end"),
        ("(int32_value = 1", "expected ) before 'the end'"),
        ("int32_value = 1)", "unexpected ')' in 'int32_value = 1)'"),
        ("int32_value NOT 1", "expected BETWEEN after NOT"),
        ("int32_value BETWEEN 1", "expected AND before 'the end'"),
        ("int32_value BETWEEN 1 OR 2", "expected AND before 'OR'"),
        ("int32_value = %5", "there is no parameter %5"),
        ("int32_value = %0", "there is no parameter %0"),
        ("int32_value = 1 2", "unexpected '2'"),
        ("int32_value ? 1", "cannot read '? 1'"),
        ("int32_value BETWEEN 'a' AND 2", "the two sides of a comparison have different types"),
        ("int32_value BETWEEN 2 AND 'a'", "the two sides of a comparison have different types"),
        ("AND int32_value = 1", "unexpected 'AND'"),
        ("int32_value = word", "field 'word' not found"),
        ("int32_value LIKE 5", "LIKE needs a text"),
        ("int32_value = ", "something is missing at the end"),
    ],
)
def test_a_filter_that_cannot_be_read_is_refused(world: Any, expression: str, told: str, capfd: Any) -> None:
    node = world.node("n")
    with pytest.raises(RuntimeError, match="failed to create contentfilteredtopic"):
        node.create_subscription(
            BasicTypes, "t", lambda _: None, 10, content_filter_options=ContentFilterOptions(expression, [])
        )
    assert f"DDSSQLFILTER Error: {told}" in capfd.readouterr().err
    assert node.count_subscribers("t") == 0


@pytest.mark.parametrize(
    ("expression", "parameters", "told"),
    [
        ("data MATCH '['", [], "bad pattern: "),
        ("data LIKE '('", [], "bad pattern: "),
        ("data LIKE data", [], "LIKE needs a text"),
        ("data MATCH %0", ["5"], "the two sides of a comparison have different types"),
        ("data = %0", ["word"], "'word' is not a number, a text or a truth value"),
        ("data = %0", ["+"], "'+' is not a number, a text or a truth value"),
        ("data = %1", ["'a'"], "there is no parameter %1"),
    ],
)
def test_a_filter_for_texts_that_cannot_be_used_is_refused(
    world: Any, expression: str, parameters: list[str], told: str, capfd: Any
) -> None:
    node = world.node("n")
    options = ContentFilterOptions(expression, parameters)
    with pytest.raises(RuntimeError, match="failed to create contentfilteredtopic"):
        node.create_subscription(String, "t", lambda _: None, 10, content_filter_options=options)
    assert f"DDSSQLFILTER Error: {told}" in capfd.readouterr().err
    assert node.count_subscribers("t") == 0


def test_a_filter_can_be_changed_and_ended(world: Any) -> None:
    node = world.node("n")
    heard: list[int] = []
    subscription = node.create_subscription(
        BasicTypes,
        "t",
        lambda message: heard.append(message.int32_value),
        10,
        content_filter_options=ContentFilterOptions("int32_value = %0", ["1"]),
    )
    publisher = node.create_publisher(BasicTypes, "t", 10)

    def send() -> list[int]:
        heard.clear()
        for message in NUMBERS:
            publisher.publish(message)
        world.settle()
        return list(heard)

    assert send() == [1]
    found = subscription.get_content_filter()
    assert (found.filter_expression, list(found.expression_parameters)) == ("int32_value = %0", ["1"])
    subscription.set_content_filter("int32_value > %0", ["2"])
    assert send() == [3, 4]
    assert subscription.get_content_filter().filter_expression == "int32_value > %0"
    with pytest.raises(RuntimeError):
        subscription.set_content_filter("nothing = 1", [])
    assert send() == [3, 4]
    subscription.set_content_filter("", [])
    assert send() == [0, 1, 2, 3, 4]
    assert not subscription.is_cft_enabled


def test_a_subscription_without_a_filter_has_none(world: Any) -> None:
    subscription = world.node("n").create_subscription(BasicTypes, "t", lambda _: None, 10)
    assert not subscription.is_cft_enabled
    with pytest.raises(RuntimeError, match="this subscriber has not created a ContentFilteredTopic"):
        subscription.get_content_filter()
    with pytest.raises(RuntimeError, match="current subscriber has no content filter topic"):
        subscription.set_content_filter("", [])


@pytest.mark.parametrize("by_node", [True, False])
def test_who_was_destroyed_is_told_nothing_more(world: Any, by_node: bool) -> None:
    node = world.node("n")
    told: list[str] = []
    publisher = node.create_publisher(
        String, "t", 1, event_callbacks=PublisherEventCallbacks(matched=lambda _: told.append("publisher"))
    )
    subscription = node.create_subscription(
        String, "t", print, 1, event_callbacks=SubscriptionEventCallbacks(matched=lambda _: told.append("subscription"))
    )
    assert [len(endpoint.event_handlers) for endpoint in (publisher, subscription)] == [3, 3]
    for endpoint, destroy in ((publisher, node.destroy_publisher), (subscription, node.destroy_subscription)):
        if by_node:
            destroy(endpoint)
        else:
            endpoint.destroy()
    world.settle()
    assert told == []
