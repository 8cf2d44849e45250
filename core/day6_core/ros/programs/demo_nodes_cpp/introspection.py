"""The parameter that switches the introspection of a client or service."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from rcl_interfaces.msg import SetParametersResult

from rclpy.parameter import Parameter
from rclpy.qos import qos_profile_system_default
from rclpy.service_introspection import ServiceIntrospectionState

if TYPE_CHECKING:
    from rclpy.node import Node

STATES = {
    "disabled": ServiceIntrospectionState.OFF,
    "metadata": ServiceIntrospectionState.METADATA,
    "contents": ServiceIntrospectionState.CONTENTS,
}


def follow_parameter(node: Node, name: str, end: Any) -> None:
    """Declare the parameter and configure `end` (a client or service) by it from now on; other values are refused."""

    def judge(parameters: list[Parameter[Any]]) -> SetParametersResult:
        for each in parameters:
            if each.name != name:
                continue
            if each.type_ != Parameter.Type.STRING:
                return SetParametersResult(successful=False, reason="must be a string")
            if each.value not in STATES:
                return SetParametersResult(
                    successful=False, reason="must be one of 'disabled', 'metadata', or 'contents'"
                )
        return SetParametersResult(successful=True)

    def follow(parameters: list[Parameter[Any]]) -> None:
        for each in parameters:
            if each.name == name:
                end.configure_introspection(node.get_clock(), qos_profile_system_default, STATES[each.value])

    node.add_on_set_parameters_callback(judge)
    node.add_post_set_parameters_callback(follow)
    node.declare_parameter(name, "disabled")
