"""introspection: a client and a server in one program, both of which can publish service events."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from example_interfaces.srv import AddTwoInts

from day6_core.ros.programs._waiting import spin
from day6_core.ros.programs.demo_nodes_cpp.introspection import follow_parameter

if TYPE_CHECKING:
    from day6_core.session.session import Session
    from rclpy.node import Node


class IntrospectionClient:
    """Sends a request twice a second."""

    def __init__(self, node: Node) -> None:
        self._node = node
        self._client = node.create_client(AddTwoInts, "add_two_ints")
        self._future: Any = None
        follow_parameter(node, "client_configure_introspection", self._client)
        node.create_timer(0.5, self._tick)

    def _tick(self) -> None:
        if not self._client.service_is_ready():
            return
        if self._future is None:
            self._future = self._client.call_async(AddTwoInts.Request(a=2, b=3))
        elif self._future.done():
            self._node.get_logger().info(f"Result of add_two_ints: {self._future.result().sum}")
            self._future = None


async def main(session: Session) -> int:
    server, client = session.create_node("introspection_service"), session.create_node("introspection_client")

    def add(request: Any, response: Any) -> Any:
        response.sum = request.a + request.b
        server.get_logger().info(f"Incoming request\na: {request.a} b: {request.b}")
        return response

    follow_parameter(server, "service_configure_introspection", server.create_service(AddTwoInts, "add_two_ints", add))
    IntrospectionClient(client)
    return await spin(session, server, client)
