"""The six services by which other programs read and set a node's parameters."""

from __future__ import annotations

import weakref
from typing import TYPE_CHECKING, Any

from day6_core.ros.differences import value
from rclpy._day6.own_services import PARAMETER_SERVICES
from rclpy.exceptions import ParameterNotDeclaredException, ParameterUninitializedException
from rclpy.parameter import Parameter
from rclpy.qos import qos_profile_parameters

if TYPE_CHECKING:
    from rclpy.node import Node

TOPIC_SEPARATOR_STRING = "/"

# Programs import the service classes from here too; they are made on first use.
_CLASSES = {
    "DescribeParameters",
    "GetParameterTypes",
    "GetParameters",
    "ListParameters",
    "SetParameters",
    "SetParametersAtomically",
}


def __getattr__(name: str) -> Any:
    if name in _CLASSES:
        import rcl_interfaces.srv

        return getattr(rcl_interfaces.srv, name)
    if name in ("ListParametersResult", "SetParametersResult"):
        import rcl_interfaces.msg

        return getattr(rcl_interfaces.msg, name)
    raise AttributeError(f"module {__name__!r} has no attribute {name!r}")


class ParameterService:
    """Serves the parameter services of a node."""

    def __init__(self, node: Node) -> None:
        self._node_weak_ref = weakref.ref(node)
        for name, type_name in PARAMETER_SERVICES:
            callback = getattr(self, f"_{name}_callback")
            node._rclpy_entities.create_own_service(
                type_name, name, callback, qos_profile_parameters, node.default_callback_group
            )

    def _get_node(self) -> Node:
        node = self._node_weak_ref()
        if node is None:
            raise ReferenceError("Expected valid node weak reference")
        return node

    def _describe_parameters_callback(self, request: Any, response: Any) -> Any:
        node = self._get_node()
        try:
            response.descriptors = [node.describe_parameter(name) for name in request.names]
        except ParameterNotDeclaredException:
            response.descriptors = []
        return response

    def _get_parameters_callback(self, request: Any, response: Any) -> Any:
        node = self._get_node()
        try:
            response.values = [node.get_parameter(name).get_parameter_value() for name in request.names]
        except (ParameterNotDeclaredException, ParameterUninitializedException):
            response.values = []
        return response

    def _get_parameter_types_callback(self, request: Any, response: Any) -> Any:
        node = self._get_node()
        try:
            response.types = [int(node.get_parameter_type(name)) for name in request.names]
        except ParameterNotDeclaredException:
            response.types = []
        return response

    def _list_parameters_callback(self, request: Any, response: Any) -> Any:
        response.result = self._get_node().list_parameters(list(request.prefixes), request.depth)
        return response

    def _set_parameters_callback(self, request: Any, response: Any) -> Any:
        response.results = [self._set([Parameter.from_parameter_msg(each)]) for each in request.parameters]
        return response

    def _set_parameters_atomically_callback(self, request: Any, response: Any) -> Any:
        response.result = self._set([Parameter.from_parameter_msg(each) for each in request.parameters])
        return response

    def _set(self, parameters: list[Parameter[Any]]) -> Any:
        from rcl_interfaces.msg import SetParametersResult

        node = self._get_node()
        try:
            result = node.set_parameters_atomically(parameters)
        except ParameterNotDeclaredException as error:
            result = SetParametersResult(successful=False, reason=str(error))
        if not result.successful and value("parameters.refusals_are_logged"):
            names = ", ".join(each.name for each in parameters)
            node.get_logger().warning(f"Failed to set parameter '{names}': {result.reason}")
        return result
