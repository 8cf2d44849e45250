"""introspection_service: a server that publishes a service event for every request, if its parameter says so."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from example_interfaces.srv import AddTwoInts

from day6_core.ros.programs._component import run
from day6_core.ros.programs.demo_nodes_cpp.introspection import follow_parameter

if TYPE_CHECKING:
    from day6_core.session.session import Session
    from rclpy.node import Node


class IntrospectionServiceNode:
    """Parameter `service_configure_introspection`: disabled, metadata or contents."""

    NAME = "introspection_service"
    OPTIONS: dict[str, Any] = {}

    def __init__(self, node: Node) -> None:
        self._node = node
        self._service = node.create_service(AddTwoInts, "add_two_ints", self._add)
        follow_parameter(node, "service_configure_introspection", self._service)

    def _add(self, request: Any, response: Any) -> Any:
        self._node.get_logger().info(f"Incoming request\na: {request.a} b: {request.b}")
        response.sum = request.a + request.b
        return response


async def main(session: Session) -> int:
    return await run(session, IntrospectionServiceNode)
