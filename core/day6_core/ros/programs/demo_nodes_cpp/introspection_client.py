"""introspection_client: sends a request twice a second, and publishes service events if its parameter says so."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from example_interfaces.srv import AddTwoInts

from day6_core.ros.programs._component import run
from day6_core.ros.programs.demo_nodes_cpp.introspection import follow_parameter

if TYPE_CHECKING:
    from day6_core.session.session import Session
    from rclpy.node import Node


class IntrospectionClientNode:
    """Parameter `client_configure_introspection`: disabled, metadata or contents."""

    NAME = "introspection_client"
    OPTIONS: dict[str, Any] = {}

    def __init__(self, node: Node) -> None:
        self._node = node
        self._client = node.create_client(AddTwoInts, "add_two_ints")
        self._waiting = False
        follow_parameter(node, "client_configure_introspection", self._client)
        node.create_timer(0.5, self._ask)

    def _ask(self) -> None:
        if not self._waiting and self._client.service_is_ready():
            self._waiting = True
            self._client.call_async(AddTwoInts.Request(a=2, b=3)).add_done_callback(self._answered)

    def _answered(self, future: Any) -> None:
        self._waiting = False
        self._node.get_logger().info(f"Result of add_two_ints: {future.result().sum}")


async def main(session: Session) -> int:
    return await run(session, IntrospectionClientNode)
