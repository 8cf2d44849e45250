"""The parameters `qos_overrides.…` of C++ nodes: who has which, and that they change the QoS of what is made."""

from __future__ import annotations

from typing import Any

import pytest
from rcl_interfaces.msg import SetParametersResult

from day6_core.graph import EndpointKind
from day6_core.graph.qos import Reliability
from day6_core.ros.programs.rclcpp.exceptions import CppException
from day6_core.ros.programs.rclcpp.parameters import CppParameterStore
from day6_core.ros.programs.rclcpp.qos import declared_qos
from rclpy.parameter import Parameter
from rclpy.qos import QoSPolicyKind, QoSProfile, ReliabilityPolicy
from rclpy.qos_overriding_options import QoSOverridingOptions

TF = [f"/tf.publisher.{each}" for each in ("depth", "durability", "history", "reliability")]
TF_STATIC = [f"/tf_static.publisher.{each}" for each in ("depth", "history", "reliability")]
CLOCK = [f"/clock.subscription.{each}" for each in ("depth", "durability", "history", "reliability")]
STATIC = ("--frame-id", "world", "--child-frame-id", "lamp")


def overrides(machine, node: str) -> list[str]:
    names = [line.strip() for line in machine.ros2("param", "list", node).stdout.splitlines()]
    return [
        name.removeprefix("qos_overrides.")
        for name in names
        if name.startswith("qos_overrides.") and "parameter_events" not in name
    ]


@pytest.mark.parametrize(
    ("package", "words", "node", "expected"),
    [
        ("turtle_tf2_cpp", ("turtle_tf2_broadcaster",), "/turtle_tf2_frame_publisher", TF),
        ("turtle_tf2_cpp", ("fixed_frame_tf2_broadcaster",), "/fixed_frame_tf2_broadcaster", TF),
        ("turtle_tf2_cpp", ("dynamic_frame_tf2_broadcaster",), "/dynamic_frame_tf2_broadcaster", TF),
        ("turtle_tf2_cpp", ("turtle_tf2_listener",), "/turtle_tf2_frame_listener", []),
        (
            *("turtle_tf2_cpp", ("static_turtle_tf2_broadcaster", "lamp", *"000000")),
            *("/static_turtle_tf2_broadcaster", TF_STATIC),
        ),
        ("tf2_ros", ("static_transform_publisher", *STATIC, "--ros-args", "-r", "__node:=s"), "/s", TF_STATIC),
        ("demo_nodes_cpp", ("talker", "--ros-args", "-p", "use_sim_time:=true"), "/talker", CLOCK),
        ("demo_nodes_cpp", ("talker",), "/talker", []),
    ],
)
def test_who_has_which(machine, package, words, node, expected):
    machine.run(package, *words)
    assert overrides(machine, node) == expected


def test_the_python_broadcasters_have_none(machine):
    machine.run("turtle_tf2_py", "fixed_frame_tf2_broadcaster")
    assert overrides(machine, "/fixed_frame_tf2_broadcaster") == []


def test_a_listener_of_tf_is_a_node_without_parameter_services(machine):
    machine.run("turtle_tf2_cpp", "turtle_tf2_listener")
    (listener,) = [name for name in machine.ros2("node", "list").stdout.split() if "transform_listener_impl_" in name]
    info = machine.ros2("node", "info", listener).stdout
    assert "/tf: tf2_msgs/msg/TFMessage" in info
    assert "parameters" not in info and "/parameter_events" not in info.partition("Publishers")[2]


def made(machine, node: str, topic: str) -> Any:
    """The QoS that the node's publisher or subscription of a topic was made with."""
    (endpoint,) = [
        each
        for each in machine.graph.endpoints(EndpointKind.PUBLISHER, EndpointKind.SUBSCRIPTION, topic=topic)
        if each.node.name == node and (topic != "/parameter_events" or each.kind is EndpointKind.PUBLISHER)
    ]
    return endpoint.qos


def test_an_override_changes_the_publisher(machine):
    arguments = (
        "-p",
        "qos_overrides./tf.publisher.reliability:=best_effort",
        "-p",
        "qos_overrides./tf.publisher.depth:=3",
    )
    machine.run("turtle_tf2_cpp", "fixed_frame_tf2_broadcaster", "--ros-args", *arguments)
    qos = made(machine, "fixed_frame_tf2_broadcaster", "/tf")
    assert (qos.reliability, qos.depth) == (Reliability.BEST_EFFORT, 3)
    assert "Reliability: BEST_EFFORT" in machine.ros2("topic", "info", "-v", "/tf").stdout
    node = "/fixed_frame_tf2_broadcaster"
    assert machine.ros2("param", "get", node, "qos_overrides./tf.publisher.depth").stdout == "Integer value is: 3\n"


def test_an_override_follows_the_remapped_topic(machine):
    arguments = ("-r", "/tf:=/tf_old", "-p", "qos_overrides./tf_old.publisher.depth:=4")
    machine.run("turtle_tf2_cpp", "fixed_frame_tf2_broadcaster", "--ros-args", *arguments)
    assert made(machine, "fixed_frame_tf2_broadcaster", "/tf_old").depth == 4


def test_an_override_changes_the_clock_of_simulated_time(machine):
    arguments = ("-p", "use_sim_time:=true", "-p", "qos_overrides./clock.subscription.reliability:=reliable")
    machine.run("demo_nodes_cpp", "talker", "--ros-args", *arguments)
    assert made(machine, "talker", "/clock").reliability is Reliability.RELIABLE


@pytest.mark.parametrize(
    ("name", "depth", "shown"),
    [("qos_overrides./parameter_events.depth", 7, 1000), ("qos_overrides./parameter_events.publisher.depth", 1000, 7)],
    ids=["the name that works", "the name that is shown"],
)
def test_parameter_events_are_overridden_by_another_name_than_is_shown(machine, name, depth, shown):
    """A slip of rclcpp: the QoS is read without `.publisher`, and only then the parameters are declared, with it."""
    machine.run("demo_nodes_cpp", "talker", "--ros-args", "-p", f"{name}:=7")
    assert made(machine, "talker", "/parameter_events").depth == depth
    shown_name = "qos_overrides./parameter_events.publisher.depth"
    assert machine.ros2("param", "get", "/talker", shown_name).stdout == f"Integer value is: {shown}\n"


# -- the rules alone ---------------------------------------------------------------------------------------------------

OTHER_TYPE = (
    "parameter 'qos_overrides./t.publisher.depth' has invalid type: Wrong parameter type, parameter "
    "{qos_overrides./t.publisher.depth} is of type {integer}, setting it to {string} is not allowed."
)
KINDS = (QoSPolicyKind.DEPTH, QoSPolicyKind.RELIABILITY, QoSPolicyKind.LIFESPAN)


def test_names_and_descriptions_carry_the_id():
    store = CppParameterStore()
    declared_qos(store, "publisher", "/t", QoSProfile(depth=5), QoSOverridingOptions(KINDS, entity_id="left"))
    assert list(store.parameters) == [
        f"qos_overrides./t.publisher_left.{each}" for each in ("depth", "lifespan", "reliability")
    ]
    described = store.describe("qos_overrides./t.publisher_left.depth")
    assert described.description == "qos policy {depth} for publisher {/t} with id {left}"


def test_a_subscription_has_no_lifespan_and_the_profile_given_stays_as_it_is():
    name = "qos_overrides./t.subscription.reliability"
    store = CppParameterStore(overrides={name: Parameter(name, value="best_effort")})
    given = QoSProfile(depth=5)
    result = declared_qos(store, "subscription", "/t", given, QoSOverridingOptions(KINDS))
    assert (result.reliability, given.reliability) == (ReliabilityPolicy.BEST_EFFORT, ReliabilityPolicy.RELIABLE)
    assert not any("lifespan" in each for each in store.parameters)


def test_a_second_endpoint_of_the_topic_takes_the_declared_values():
    store = CppParameterStore()
    declared_qos(store, "publisher", "/t", QoSProfile(depth=5), QoSOverridingOptions(KINDS))
    assert declared_qos(store, "publisher", "/t", QoSProfile(depth=9), QoSOverridingOptions(KINDS)).depth == 5


@pytest.mark.parametrize(
    ("policy", "value", "kind", "what"),
    [
        ("reliability", "zzz", "std::invalid_argument", "unknown QoS policy reliability value: zzz"),
        (
            *("depth", -1, "rclcpp::exceptions::RCLError"),
            "failed to set history depth since the requested queue size exceeds the DDS type",
        ),
        (
            *("depth", "many", "rclcpp::exceptions::InvalidParameterTypeException"),
            OTHER_TYPE,
        ),
    ],
)
def test_a_value_that_no_policy_has_is_thrown(policy, value, kind, what):
    name = f"qos_overrides./t.publisher.{policy}"
    store = CppParameterStore(overrides={name: Parameter(name, value=value)})
    with pytest.raises(CppException) as thrown:
        declared_qos(store, "publisher", "/t", QoSProfile(depth=5), QoSOverridingOptions(KINDS))
    assert (thrown.value.kind, str(thrown.value)) == (kind, what)


def test_a_program_may_refuse_the_result():
    options = QoSOverridingOptions(KINDS, callback=lambda qos: SetParametersResult(successful=False, reason="too few"))
    with pytest.raises(CppException, match=r"^validation callback failed: too few$") as thrown:
        declared_qos(CppParameterStore(), "publisher", "/t", QoSProfile(depth=5), options)
    assert thrown.value.kind == "rclcpp::exceptions::InvalidQosOverridesException"
