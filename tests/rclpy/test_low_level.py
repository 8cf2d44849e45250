"""What `rclpy.impl.implementation_singleton` offers: numbers of enumerations, handles made and used by hand."""

from __future__ import annotations

from typing import Any

import pytest
from std_msgs.msg import String
from std_srvs.srv import Trigger
from test_msgs.msg import BasicTypes

from rclpy.duration import Duration
from rclpy.impl.implementation_singleton import rclpy_implementation as low_level
from rclpy.qos import QoSProfile
from rclpy.serialization import serialize_message
from rclpy.service_introspection import ServiceIntrospectionState
from rclpy.subscription_content_filter_options import ContentFilterOptions

QOS = QoSProfile(depth=5).get_c_qos_profile()


@pytest.mark.parametrize(
    ("enumeration", "numbers"),
    [
        ("ClockType", {"UNINITIALIZED": 0, "ROS_TIME": 1, "SYSTEM_TIME": 2, "STEADY_TIME": 3}),
        (
            "ClockChange",
            {"ROS_TIME_NO_CHANGE": 1, "ROS_TIME_ACTIVATED": 2, "ROS_TIME_DEACTIVATED": 3, "SYSTEM_TIME_NO_CHANGE": 4},
        ),
        ("GoalEvent", {"EXECUTE": 0, "CANCEL_GOAL": 1, "SUCCEED": 2, "ABORT": 3, "CANCELED": 4}),
        ("SignalHandlerOptions", {"NO": 0, "SIGINT": 1, "SIGTERM": 2, "ALL": 3}),
        ("QoSCompatibility", {"OK": 0, "WARNING": 1, "ERROR": 2}),
        ("TransitionCallbackReturnType", {"SUCCESS": 97, "FAILURE": 98, "ERROR": 99}),
        (
            "rcl_publisher_event_type_t",
            {
                "RCL_PUBLISHER_OFFERED_DEADLINE_MISSED": 0,
                "RCL_PUBLISHER_LIVELINESS_LOST": 1,
                "RCL_PUBLISHER_OFFERED_INCOMPATIBLE_QOS": 2,
                "RCL_PUBLISHER_INCOMPATIBLE_TYPE": 3,
                "RCL_PUBLISHER_MATCHED": 4,
            },
        ),
        (
            "rcl_subscription_event_type_t",
            {
                "RCL_SUBSCRIPTION_REQUESTED_DEADLINE_MISSED": 0,
                "RCL_SUBSCRIPTION_LIVELINESS_CHANGED": 1,
                "RCL_SUBSCRIPTION_REQUESTED_INCOMPATIBLE_QOS": 2,
                "RCL_SUBSCRIPTION_MESSAGE_LOST": 3,
                "RCL_SUBSCRIPTION_INCOMPATIBLE_TYPE": 4,
                "RCL_SUBSCRIPTION_MATCHED": 5,
            },
        ),
    ],
)
def test_enumerations_have_the_numbers_of_rcl(enumeration: str, numbers: dict[str, int]) -> None:
    members = getattr(low_level, enumeration)
    for name, number in numbers.items():
        assert int(getattr(members, name)) == getattr(members, name).value == number
        assert getattr(members, name).name == name
    assert len({getattr(members, name) for name in numbers}) == len(numbers)


def test_what_introspection_tells_has_a_number() -> None:
    state = ServiceIntrospectionState
    assert [int(each) for each in (state.OFF, state.METADATA, state.CONTENTS)] == [0, 1, 2]


def test_the_results_of_transitions_have_labels() -> None:
    result = low_level.TransitionCallbackReturnType
    assert [each.to_label() for each in (result.SUCCESS, result.FAILURE, result.ERROR)] == [
        "transition_success",
        "transition_failure",
        "transition_error",
    ]


def test_the_kinds_of_policies_are_powers_of_two() -> None:
    kinds = low_level.rmw_qos_policy_kind_t
    names = (
        "INVALID",
        "DURABILITY",
        "DEADLINE",
        "LIVELINESS",
        "RELIABILITY",
        "HISTORY",
        "LIFESPAN",
        "DEPTH",
        "LIVELINESS_LEASE_DURATION",
        "AVOID_ROS_NAMESPACE_CONVENTIONS",
    )
    assert [int(getattr(kinds, f"RMW_QOS_POLICY_{name}")) for name in names] == [2**power for power in range(10)]


def test_constants_are_those_of_rmw() -> None:
    assert low_level.RCL_DEFAULT_DOMAIN_ID == 2**64 - 1
    assert low_level.RMW_DURATION_INFINITE == 2**63 - 1
    assert low_level.RMW_QOS_DEADLINE_BEST_AVAILABLE == 2**63 - 2
    assert low_level.RMW_QOS_LIVELINESS_LEASE_DURATION_BEST_AVAILABLE == 2**63 - 2


def test_a_profile_is_found_by_its_name() -> None:
    for name, depth in (("qos_profile_default", 10), ("qos_profile_sensor_data", 5), ("qos_profile_parameters", 1000)):
        assert low_level.rmw_qos_profile_t.predefined(name).to_dict()["depth"] == depth
    for wrong in ("default", "qos_profile_nothing"):
        with pytest.raises(ValueError, match=f"Requested unknown rmw_qos_profile: {wrong}"):
            low_level.rmw_qos_profile_t.predefined(wrong)


def test_a_publisher_is_used_by_hand(world: Any) -> None:
    node = world.node("n")
    publisher = low_level.Publisher(node.handle, String, "t", QOS)
    heard: list[str] = []
    assert publisher.get_subscription_count() == 0
    node.create_subscription(String, "t", lambda message: heard.append(message.data), 10)
    world.settle()
    assert publisher.get_subscription_count() == 1
    publisher.publish(String(data="object"))
    publisher.publish_raw(serialize_message(String(data="bytes")))
    world.settle()
    assert heard == ["object", "bytes"]
    assert publisher.get_topic_name() == "/t"
    assert publisher.get_logger_name() == "n"
    assert publisher.wait_for_all_acked(Duration(seconds=1).get_c_duration())
    publisher.destroy_when_not_in_use()
    with pytest.raises(RuntimeError):
        publisher.publish(String())


def test_a_subscription_is_used_by_hand(world: Any) -> None:
    node = world.node("n", namespace="lab", cli_args=["--ros-args", "-r", "t:=/u"])
    subscription = low_level.Subscription(node.handle, BasicTypes, "t", QOS)
    publisher = node.create_publisher(BasicTypes, "/u", 10)
    world.settle()
    assert subscription.get_topic_name() == "/u"
    assert subscription.get_publisher_count() == 1
    assert subscription.take_message(BasicTypes, False) is None
    publisher.publish(BasicTypes(int32_value=3))
    publisher.publish(BasicTypes(int32_value=4))
    world.settle()
    message, _ = subscription.take_message(BasicTypes, False)
    assert message.int32_value == 3
    data, info = subscription.take_message(BasicTypes, True)
    assert data == serialize_message(BasicTypes(int32_value=4))
    assert info["source_timestamp"] > 10**18
    assert not subscription.is_cft_enabled()


def test_a_filter_is_given_by_hand(world: Any) -> None:
    node = world.node("n")
    options = ContentFilterOptions("int32_value = %0", ["3"])
    subscription = low_level.Subscription(node.handle, BasicTypes, "t", QOS, options)
    assert subscription.is_cft_enabled()
    assert subscription.get_content_filter().filter_expression == "int32_value = %0"
    subscription.set_content_filter("int32_value = 4", [])
    assert subscription.get_content_filter().filter_expression == "int32_value = 4"


def test_wrong_names_are_refused_by_handles_too(world: Any) -> None:
    node = world.node("n")
    for make in (
        lambda: low_level.Publisher(node.handle, String, "a b", QOS),
        lambda: low_level.Subscription(node.handle, String, "a b", QOS),
        lambda: low_level.Service(node.handle, Trigger, "a b", QOS),
        lambda: low_level.Client(node.handle, Trigger, "a b", QOS),
    ):
        with pytest.raises((ValueError, RuntimeError)):
            make()


def test_a_nodes_handle_knows_its_names(world: Any) -> None:
    handle = world.node("n", namespace="lab").handle
    assert (handle.get_node_name(), handle.get_namespace(), handle.get_fully_qualified_name()) == (
        "n",
        "/lab",
        "/lab/n",
    )
    assert handle.logger_name() == "lab.n"
    with handle:
        assert handle.pointer
    with pytest.raises(AttributeError, match="handle"):
        world.node("m").handle = handle


def test_a_contexts_handle_knows_its_domain(world: Any) -> None:
    handle = world.context.handle
    assert handle.ok()
    assert handle.get_domain_id() == world.context.get_domain_id()
    world.context.shutdown()
    assert not handle.ok()


def test_a_guard_condition_is_triggered_by_hand(world: Any) -> None:
    guard = low_level.GuardCondition(world.context.handle)
    guard.trigger_guard_condition()
    guard.destroy_when_not_in_use()
    with pytest.raises(RuntimeError):
        guard.trigger_guard_condition()


def test_an_event_is_taken_by_hand(world: Any) -> None:
    node = world.node("n")
    publisher = low_level.Publisher(node.handle, String, "t", QOS)
    event = low_level.EventHandle(publisher, low_level.rcl_publisher_event_type_t.RCL_PUBLISHER_MATCHED)
    wait_set = low_level.WaitSet(0, 0, 0, 0, 0, 1, world.context.handle)
    assert wait_set.add_event(event) == 0
    with pytest.raises(RuntimeError, match="failed to add event to wait set: events set is full"):
        wait_set.add_event(event)
    wait_set.wait(0)
    assert not wait_set.is_ready("event", 0)
    node.create_subscription(String, "t", lambda _: None, 1)
    wait_set.clear_entities()
    wait_set.add_event(event)
    wait_set.wait(1_000_000_000)
    assert wait_set.is_ready("event", 0)
    status = event.take_event()
    assert (status.total_count, status.current_count, status.current_count_change) == (1, 1, 1)


def test_members_equal_their_own_number_and_no_other() -> None:
    matched = low_level.rcl_publisher_event_type_t.RCL_PUBLISHER_MATCHED
    number = int(matched)
    assert matched == number
    assert matched != number + 1
    assert matched == type(matched)(number)
    assert matched != "RCL_PUBLISHER_MATCHED"
    assert hash(matched) == hash(number)
