"""Deadlines, liveliness, content filters, wait sets and the events executor, by a clock that only moves when stepped."""

from __future__ import annotations

from typing import Any

import pytest
from std_msgs.msg import String
from std_srvs.srv import Trigger
from test_msgs.msg import BasicTypes, Strings

from rclpy.callback_groups import ReentrantCallbackGroup
from rclpy.duration import Duration
from rclpy.event_handler import PublisherEventCallbacks, SubscriptionEventCallbacks
from rclpy.experimental import EventsExecutor
from rclpy.impl.implementation_singleton import rclpy_implementation as low_level
from rclpy.qos import LivelinessPolicy, QoSProfile
from rclpy.subscription_content_filter_options import ContentFilterOptions
from rclpy.task import Future

DEADLINE = QoSProfile(depth=10, deadline=Duration(seconds=1))
MANUAL = QoSProfile(
    depth=10, liveliness=LivelinessPolicy.MANUAL_BY_TOPIC, liveliness_lease_duration=Duration(seconds=1)
)


def test_both_sides_of_a_topic_are_told_of_every_missed_deadline(world: Any) -> None:
    node = world.node("n")
    told: list[tuple[str, int, int]] = []

    def tell(side: str) -> Any:
        return lambda info: told.append((side, info.total_count, info.total_count_change))

    publisher = node.create_publisher(
        String, "t", DEADLINE, event_callbacks=PublisherEventCallbacks(deadline=tell("offered"))
    )
    node.create_subscription(
        String, "t", lambda _: None, DEADLINE, event_callbacks=SubscriptionEventCallbacks(deadline=tell("requested"))
    )
    world.run(5.0)
    assert told == []
    publisher.publish(String())
    world.run(2.5)
    assert sorted(told) == [("offered", 1, 1), ("offered", 2, 1), ("requested", 1, 1), ("requested", 2, 1)]
    told.clear()
    for _ in range(5):
        publisher.publish(String())
        world.run(0.9)
    assert told == []


def test_a_node_without_deadlines_gives_its_executor_nothing_to_wait_for(world: Any) -> None:
    node = world.node("n")
    publisher = node.create_publisher(String, "t", 10)
    node.create_subscription(String, "t", lambda _: None, 10)
    publisher.publish(String())
    world.settle()
    assert world.executor._next_deadline() is None


def test_a_manual_publisher_dies_when_its_lease_is_over_and_lives_again_with_a_message(world: Any) -> None:
    node = world.node("n")
    told: list[Any] = []
    publisher = node.create_publisher(
        String, "t", MANUAL, event_callbacks=PublisherEventCallbacks(liveliness=lambda i: told.append(i.total_count))
    )
    node.create_subscription(
        String,
        "t",
        lambda _: None,
        MANUAL,
        event_callbacks=SubscriptionEventCallbacks(
            liveliness=lambda i: told.append((i.alive_count, i.not_alive_count))
        ),
    )
    publisher.assert_liveliness()
    world.run(0.5)
    assert told == [(1, 0)]
    world.run(1.0)
    assert sorted(told, key=str) == [(0, 1), (1, 0), 1]
    told.clear()
    publisher.publish(String())
    world.settle()
    assert told == [(1, 0)]


@pytest.mark.parametrize(
    ("expression", "parameters", "expected"),
    [
        ("int32_value > %0", ["1"], [2, 3]),
        ("int32_value = 1 OR int32_value = %1", ["9", "3"], [1, 3]),
        ("NOT int32_value BETWEEN 1 AND 2", [], [0, 3]),
        ("int32_value not between 1 and 2", [], [0, 3]),
        ("bool_value = TRUE AND (float64_value < 1.5 OR int32_value <> 2)", [], [0]),
        ("int32_value >= float64_value", [], [0, 1, 2, 3]),
    ],
)
def test_a_content_filter_lets_through_what_it_says(
    world: Any, expression: str, parameters: list[str], expected: list[int]
) -> None:
    node = world.node("n")
    publisher = node.create_publisher(BasicTypes, "t", 10)
    got: list[int] = []
    options = ContentFilterOptions(expression, parameters)
    node.create_subscription(BasicTypes, "t", lambda m: got.append(m.int32_value), 10, content_filter_options=options)
    for value in range(4):
        publisher.publish(BasicTypes(int32_value=value, bool_value=value % 2 == 0, float64_value=float(value)))
    world.settle()
    assert got == expected


def test_texts_are_filtered_by_patterns(world: Any) -> None:
    node = world.node("n")
    publisher = node.create_publisher(Strings, "t", 10)
    got: list[str] = []
    subscription = node.create_subscription(Strings, "t", lambda m: got.append(m.string_value), 10)
    subscription.set_content_filter("string_value LIKE 'ba_%'", [])
    for text in ("bar", "baz", "ba", "abar"):
        publisher.publish(Strings(string_value=text))
    world.settle()
    assert got == ["bar", "baz"]


def test_what_a_wait_set_waits_for_is_ready_after_it(world: Any) -> None:
    node = world.node("n")
    subscription = low_level.Subscription(node.handle, String, "t", QoSProfile(depth=3).get_c_qos_profile())
    guard = low_level.GuardCondition(world.context.handle)
    wait_set = low_level.WaitSet(1, 1, 0, 0, 0, 0, world.context.handle)
    assert (wait_set.add_subscription(subscription), wait_set.add_guard_condition(guard)) == (0, 0)
    wait_set.wait(0)
    assert wait_set.get_ready_entities("subscription") == []
    node.create_publisher(String, "t", 3).publish(String(data="x"))
    guard.trigger_guard_condition()
    wait_set.wait(-1)
    assert wait_set.is_ready("subscription", 0) and wait_set.is_ready("guard_condition", 0)
    message, info = subscription.take_message(String, False)
    assert (message.data, info["publication_sequence_number"]) == ("x", 1)
    wait_set.wait(0)
    assert not wait_set.is_ready("subscription", 0) and not wait_set.is_ready("guard_condition", 0)
    with pytest.raises(low_level.RCLError, match="set is full"):
        wait_set.add_subscription(subscription)


def test_the_events_executor_lets_a_waiting_coroutine_hold_up_nothing(world: Any) -> None:
    node = world.node("n")
    executor = EventsExecutor(context=world.context)
    executor.add_node(node)
    released: Future[str] = Future()

    async def answer(_request: Any, response: Any) -> Any:
        response.message = await released
        return response

    node.create_service(Trigger, "s", answer)
    node.create_subscription(String, "t", lambda m: released.set_result(m.data), 10)
    client = node.create_client(Trigger, "s", callback_group=ReentrantCallbackGroup())
    future = client.call_async(Trigger.Request())
    executor.spin_until_future_complete(future, 0.0)
    assert not future.done()
    node.create_publisher(String, "t", 10).publish(String(data="go"))
    executor.spin_until_future_complete(future, 0.0)
    assert future.result().message == "go"
