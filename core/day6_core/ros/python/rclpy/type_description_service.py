"""The service that returns the definitions of the types a node uses."""

from __future__ import annotations

import weakref
from typing import TYPE_CHECKING, Any

from day6_core.ros.differences import value
from rclpy._day6.incidental import also
from rclpy._day6.own_services import GET_TYPE_DESCRIPTION
from rclpy.parameter import Parameter
from rclpy.qos import qos_profile_services_default

if TYPE_CHECKING:
    from rclpy.node import Node

__getattr__ = also(
    __name__,
    "TOPIC_SEPARATOR_STRING GetTypeDescription ParameterDescriptor ParameterType Service check_is_valid_srv_type",
)


START_TYPE_DESCRIPTION_SERVICE_PARAM = "start_type_description_service"


class TypeDescriptionService:
    """Serves `~/get_type_description` unless the parameter `start_type_description_service` is false."""

    def __init__(self, node: Node) -> None:
        self._node_weak_ref = weakref.ref(node)
        name = START_TYPE_DESCRIPTION_SERVICE_PARAM
        self.service_name = f"{node.get_name()}/get_type_description"
        self.enabled = False
        if not value("node.describes_types"):
            return
        self._declare(node, name)
        parameter = node.get_parameter(name)
        if parameter.type_ == Parameter.Type.BOOL:
            self.enabled = parameter.value
        elif parameter.type_ == Parameter.Type.NOT_SET:
            node.get_logger().debug(f"Parameter {name} not set, defaulting to true.")
        else:
            node.get_logger().error(f"Invalid type for parameter '{name}' {parameter.type_!r} should be bool")
        if self.enabled:
            node._rclpy_entities.create_own_service(
                GET_TYPE_DESCRIPTION,
                "get_type_description",
                self._service_callback,
                qos_profile_services_default,
                node.default_callback_group,
            )

    def _declare(self, node: Node, name: str) -> None:
        if not node.has_parameter(name):
            description = "If enabled, start the ~/get_type_description service."
            node._rclpy_parameters.declare_plain(name, True, description=description, read_only=True)

    def destroy(self) -> None:
        """End the service; it ends with its node's other services."""
        self.enabled = False

    def _service_callback(self, request: Any, response: Any) -> Any:
        from rclpy._day6.type_descriptions import fill_response

        node = self._node_weak_ref()
        if node is None:
            raise ReferenceError("Expected valid node weak reference")
        return fill_response(node.handle, request, response)
