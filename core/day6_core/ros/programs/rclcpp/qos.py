"""`qos_overrides.<topic>.<publisher|subscription>.<policy>`: parameters that change an endpoint's QoS when it is made.

The rules are those of rclcpp/detail/qos_parameters.hpp. Which endpoints have them is the program's choice. In ROS's own packages
these are the broadcasters and listeners of tf2_ros (`DYNAMIC_TF`, `STATIC_TF`), robot_state_publisher's `joint_states`, and each
node's /parameter_events and, while it uses simulated time, /clock.
"""

from __future__ import annotations

import copy
from typing import TYPE_CHECKING, Any

from day6_core.ros.programs.rclcpp.exceptions import CppException, RclcppException
from day6_core.ros.programs.rclcpp.parameters import TYPE_NAMES
from rclpy.parameter import Parameter
from rclpy.qos import QoSPolicyKind, QoSProfile
from rclpy.qos_overriding_options import (
    QoSOverridingOptions,
    _get_qos_policy_parameter,
    _override_qos_policy_with_param,
)

if TYPE_CHECKING:
    from rclpy._day6.parameter_store import ParameterStore

_Kind = QoSPolicyKind

_ORDER = sorted(set(_Kind) - {_Kind.INVALID}, key=lambda kind: "HISTORY_DEPTH" if kind == _Kind.DEPTH else kind.name)
"""In which they are declared, however the program names them."""

ALL_FOUR = (_Kind.DEPTH, _Kind.DURABILITY, _Kind.HISTORY, _Kind.RELIABILITY)

DYNAMIC_TF = QoSOverridingOptions(ALL_FOUR)
"""Of /tf: tf2_ros/transform_broadcaster.h and transform_listener.h."""

STATIC_TF = QoSOverridingOptions((_Kind.DEPTH, _Kind.HISTORY, _Kind.RELIABILITY))
"""Of /tf_static, which is always transient local: tf2_ros/static_transform_broadcaster.h and transform_listener.h."""

_LARGEST_DEPTH = 2**31 - 1


def declared_qos(
    parameters: ParameterStore, entity: str, topic: str, qos: QoSProfile, options: QoSOverridingOptions
) -> QoSProfile:
    """Declare the parameters of an entity ('publisher' or 'subscription') of a topic; return the QoS that they make of `qos`.

    Raises CppException for a value of the wrong type or one that no policy has.
    """
    qos = copy.copy(qos)
    ending = "" if options.entity_id is None else f"_{options.entity_id}"
    of_entity = f"for {entity} {{{topic}}}" + ("" if options.entity_id is None else f" with id {{{options.entity_id}}}")
    for policy in _ORDER:
        if policy not in options.policy_kinds or (policy == _Kind.LIFESPAN and entity != "publisher"):
            continue
        word = policy.name.lower()
        name = f"qos_overrides.{topic}.{entity}{ending}.{word}"
        if not parameters.has(name):
            parameters.declare_plain(
                name,
                _get_qos_policy_parameter(qos, policy),
                description=f"qos policy {{{word}}} {of_entity}",
                read_only=True,
            )
        apply(qos, policy, parameters.get(name))
    if options.callback is not None:
        result = options.callback(qos)
        if not result.successful:
            raise RclcppException(f"validation callback failed: {result.reason}", "InvalidQosOverridesException")
    return qos


def apply(qos: QoSProfile, policy: QoSPolicyKind, parameter: Parameter[Any]) -> None:
    """Change a policy of `qos` to a parameter's value. Raises CppException."""
    word = policy.name.lower()
    if policy == _Kind.DEPTH and not 0 <= parameter.value <= _LARGEST_DEPTH:
        # A negative one becomes a very large one; Fast DDS says so when the endpoint is made.
        what = "failed to set history depth since the requested queue size exceeds the DDS type"
        raise RclcppException(what, "RCLError")
    try:
        _override_qos_policy_with_param(qos, policy, parameter)
    except RuntimeError as error:
        raise CppException(f"unknown QoS policy {word} value: {parameter.value}", "std::invalid_argument") from error


def event_qos(qos: QoSProfile, overrides: dict[str, Parameter[Any]], topic: str) -> QoSProfile:
    """Return the QoS of the publisher of /parameter_events.

    It is made before the node can declare parameters, and rclcpp (node.cpp, get_parameter_events_qos) looks for initial values
    without `.publisher` in their names: those change it, and what the declared parameters say does not.
    """
    changed = copy.copy(qos)
    for policy in ALL_FOUR:
        parameter = overrides.get(f"qos_overrides.{topic}.{policy.name.lower()}")
        if parameter is not None:
            wanted = Parameter("", value=_get_qos_policy_parameter(qos, policy)).type_
            if parameter.type_ != wanted:
                what = f"expected [{TYPE_NAMES[wanted]}] got [{TYPE_NAMES[parameter.type_]}]"
                raise CppException(what, "rclcpp::ParameterTypeException")
            apply(changed, policy, parameter)
    return changed
