"""`~/get_type_description`: a node describes the types it uses to whoever asks by their hash."""

from __future__ import annotations

import weakref
from typing import TYPE_CHECKING, Any

from rcl_interfaces.msg import ParameterDescriptor, ParameterType
from type_description_interfaces.srv import GetTypeDescription

from rclpy.parameter import Parameter
from rclpy.qos import qos_profile_services_default

if TYPE_CHECKING:
    from rclpy.node import Node

START_TYPE_DESCRIPTION_SERVICE_PARAM = "start_type_description_service"


class TypeDescriptionService:
    """Declares the parameter `start_type_description_service` and, unless it is false, offers the service."""

    def __init__(self, node: Node) -> None:
        self._node_weak_ref = weakref.ref(node)
        self.service_name = f"{node.get_name()}/get_type_description"
        self.enabled = False
        if not node.has_parameter(START_TYPE_DESCRIPTION_SERVICE_PARAM):
            descriptor = ParameterDescriptor(
                name=START_TYPE_DESCRIPTION_SERVICE_PARAM,
                type=ParameterType.PARAMETER_BOOL,
                description="If enabled, start the ~/get_type_description service.",
                read_only=True,
            )
            node.declare_parameter(START_TYPE_DESCRIPTION_SERVICE_PARAM, True, descriptor)
        parameter = node.get_parameter(START_TYPE_DESCRIPTION_SERVICE_PARAM)
        if parameter.type_ == Parameter.Type.BOOL:
            self.enabled = parameter.value
        elif parameter.type_ != Parameter.Type.NOT_SET:
            node.get_logger().error(
                f"Invalid type for parameter '{START_TYPE_DESCRIPTION_SERVICE_PARAM}' "
                f"{parameter.type_!r} should be bool"
            )
        if self.enabled:
            node.create_service(
                GetTypeDescription, self.service_name, self._answer, qos_profile=qos_profile_services_default
            )

    def destroy(self) -> None:
        """End the service; it goes with its node."""

    def _answer(self, request: Any, response: Any) -> Any:
        node = self._node_weak_ref()
        if node is None:
            raise ReferenceError("Expected valid node weak reference")
        if not request.type_hash.startswith("RIHS01_") or len(request.type_hash) != len("RIHS01_") + 64:
            response.failure_reason = "Failed to parse type hash"
            return response
        used = {endpoint.type_hash: endpoint.type_name for endpoint in node._graph_node.endpoints}
        name = used.get(request.type_hash)
        if name is None:
            response.failure_reason = "Type not currently in use by this node"
            return response
        _describe(name, response, sources=request.include_type_sources)
        response.successful = True
        return response


def _describe(name: str, response: Any, *, sources: bool) -> None:
    """Fill in the description of a type and of all types it refers to."""
    import json

    from type_description_interfaces.msg import IndividualTypeDescription, TypeDescription, TypeSource

    from day6_tui.core.interfaces import definition_text
    from day6_tui.core.interfaces.hashing import description_text

    def individual(part: dict[str, Any]) -> IndividualTypeDescription:
        from type_description_interfaces.msg import Field, FieldType

        fields = [Field(name=each["name"], type=FieldType(**each["type"])) for each in part["fields"]]
        return IndividualTypeDescription(type_name=part["type_name"], fields=fields)

    whole = json.loads(description_text(name))
    own, others = whole["type_description"], whole["referenced_type_descriptions"]
    response.type_description = TypeDescription(
        type_description=individual(own), referenced_type_descriptions=[individual(each) for each in others]
    )
    if sources:
        response.type_sources = [
            TypeSource(
                type_name=part["type_name"],
                encoding=part["type_name"].split("/")[1],
                raw_file_contents=definition_text(part["type_name"]),
            )
            for part in (own, *others)
        ]
