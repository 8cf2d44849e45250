"""QoS that parameters change from outside when an endpoint is made."""

from __future__ import annotations

from typing import Any

import pytest
from rcl_interfaces.msg import SetParametersResult
from std_msgs.msg import String

from rclpy.duration import Duration
from rclpy.parameter import Parameter
from rclpy.publisher import Publisher
from rclpy.qos import (
    DurabilityPolicy,
    HistoryPolicy,
    LivelinessPolicy,
    QoSPolicyKind,
    QoSProfile,
    ReliabilityPolicy,
)
from rclpy.qos_overriding_options import InvalidQosOverridesError, QoSOverridingOptions, _declare_qos_parameters

ALL = [kind for kind in QoSPolicyKind if kind != QoSPolicyKind.INVALID]


def make(node: Any, side: str, qos: QoSProfile, options: QoSOverridingOptions) -> Any:
    if side == "publisher":
        return node.create_publisher(String, "t", qos, qos_overriding_options=options)
    return node.create_subscription(String, "t", lambda _: None, qos, qos_overriding_options=options)


@pytest.mark.parametrize("side", ["publisher", "subscription"])
@pytest.mark.parametrize(
    ("policy", "value", "name", "expected"),
    [
        ("depth", 7, "depth", 7),
        ("history", "keep_all", "history", HistoryPolicy.KEEP_ALL),
        ("history", "KEEP_ALL", "history", HistoryPolicy.KEEP_ALL),
        ("reliability", "best_effort", "reliability", ReliabilityPolicy.BEST_EFFORT),
        ("durability", "transient_local", "durability", DurabilityPolicy.TRANSIENT_LOCAL),
        ("liveliness", "manual_by_topic", "liveliness", LivelinessPolicy.MANUAL_BY_TOPIC),
        ("deadline", 5, "deadline", Duration(nanoseconds=5)),
        ("liveliness_lease_duration", 6, "liveliness_lease_duration", Duration(nanoseconds=6)),
        ("avoid_ros_namespace_conventions", True, "avoid_ros_namespace_conventions", True),
    ],
)
def test_a_parameter_changes_a_policy(world: Any, side: str, policy: str, value: Any, name: str, expected: Any) -> None:
    override = Parameter(f"qos_overrides./t.{side}.{policy}", value=value)
    node = world.node("n", parameter_overrides=[override])
    endpoint = make(node, side, QoSProfile(depth=3), QoSOverridingOptions(ALL))
    assert getattr(endpoint.qos_profile, name) == expected
    untouched = QoSProfile(depth=3)
    for other in ("depth", "history", "reliability", "durability", "deadline", "lifespan", "liveliness"):
        if other != name:
            assert getattr(endpoint.qos_profile, other) == getattr(untouched, other)


def test_the_lifespan_is_a_matter_of_the_publisher(world: Any) -> None:
    overrides = [Parameter(f"qos_overrides./t.{side}.lifespan", value=9) for side in ("publisher", "subscription")]
    node = world.node("n", parameter_overrides=overrides)
    options = QoSOverridingOptions([QoSPolicyKind.LIFESPAN])
    assert make(node, "publisher", QoSProfile(depth=1), options).qos_profile.lifespan == Duration(nanoseconds=9)
    assert make(node, "subscription", QoSProfile(depth=1), options).qos_profile.lifespan == Duration()
    assert node.has_parameter("qos_overrides./t.publisher.lifespan")
    assert not node.has_parameter("qos_overrides./t.subscription.lifespan")


def test_policies_become_read_only_parameters(world: Any) -> None:
    node = world.node("n")
    make(node, "publisher", QoSProfile(depth=3), QoSOverridingOptions.with_default_policies())
    found = node.get_parameters_by_prefix("qos_overrides./t.publisher")
    assert {name: each.value for name, each in found.items()} == {
        "history": "keep_last",
        "depth": 3,
        "reliability": "reliable",
    }
    descriptor = node.describe_parameter("qos_overrides./t.publisher.depth")
    assert descriptor.read_only
    assert descriptor.description == "depth for publisher `/t` with id `None`"


def test_an_id_tells_two_endpoints_of_a_topic_apart(world: Any) -> None:
    overrides = [Parameter("qos_overrides./t.publisher_b.depth", value=7)]
    node = world.node("n", parameter_overrides=overrides)
    depths = []
    for entity in ("a", "b", "b"):
        options = QoSOverridingOptions([QoSPolicyKind.DEPTH], entity_id=entity)
        depths.append(make(node, "publisher", QoSProfile(depth=3), options).qos_profile.depth)
    assert depths == [3, 7, 7]
    description = node.describe_parameter("qos_overrides./t.publisher_a.depth").description
    assert description == "depth for publisher `/t` with id `a`"


def test_a_callback_judges_the_result(world: Any) -> None:
    judged: list[int] = []

    def judge(qos: QoSProfile) -> SetParametersResult:
        judged.append(qos.depth)
        return SetParametersResult(successful=qos.depth < 5, reason="too deep")

    node = world.node("n", parameter_overrides=[Parameter("qos_overrides./t.subscription.depth", value=7)])
    options = QoSOverridingOptions.with_default_policies(callback=judge, entity_id=None)
    assert make(node, "publisher", QoSProfile(depth=3), options)
    with pytest.raises(InvalidQosOverridesError, match=r"Provided QoS overrides.*are not valid: too deep"):
        make(node, "subscription", QoSProfile(depth=3), options)
    assert judged == [3, 7]


def test_options_keep_what_they_were_made_of() -> None:
    def judge(_: QoSProfile) -> Any:
        return None

    options = QoSOverridingOptions([QoSPolicyKind.DEPTH], callback=judge, entity_id="x")
    assert (list(options.policy_kinds), options.callback, options.entity_id) == ([QoSPolicyKind.DEPTH], judge, "x")
    default = QoSOverridingOptions.with_default_policies(callback=judge, entity_id="y")
    assert set(default.policy_kinds) == {QoSPolicyKind.HISTORY, QoSPolicyKind.DEPTH, QoSPolicyKind.RELIABILITY}
    assert (default.callback, default.entity_id) == (judge, "y")


def test_a_choice_that_there_is_not_is_refused(world: Any) -> None:
    node = world.node("n", parameter_overrides=[Parameter("qos_overrides./t.publisher.history", value="keep_few")])
    with pytest.raises(RuntimeError, match="Unexpected QoS override for policy `history`: `keep_few`"):
        make(node, "publisher", QoSProfile(depth=3), QoSOverridingOptions.with_default_policies())
    unknown = QoSProfile(depth=1, reliability=ReliabilityPolicy.UNKNOWN)
    with pytest.raises(ValueError, match="User provided QoS profile is invalid"):
        make(world.node("m"), "publisher", unknown, QoSOverridingOptions([QoSPolicyKind.RELIABILITY]))


def test_the_private_function_that_tests_of_programs_call_takes_a_node(world: Any) -> None:
    """As rclpy/test/test_qos_overriding_options.py calls it."""
    node = world.node("n", parameter_overrides=[Parameter("qos_overrides./t.publisher.depth", value=9)])
    qos = QoSProfile(depth=3)
    _declare_qos_parameters(Publisher, node, "/t", qos, QoSOverridingOptions.with_default_policies())
    assert qos.depth == 9 and node.has_parameter("qos_overrides./t.publisher.history")
