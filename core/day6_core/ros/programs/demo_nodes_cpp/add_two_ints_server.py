"""add_two_ints_server: adds the two numbers of each request."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from example_interfaces.srv import AddTwoInts

from day6_core.ros.programs._component import run

if TYPE_CHECKING:
    from day6_core.session.session import Session
    from rclpy.node import Node


class ServerNode:
    """Parameter `one_shot`: ends after the first request."""

    NAME = "add_two_ints_server"
    OPTIONS: dict[str, Any] = {}

    def __init__(self, node: Node) -> None:
        self._node = node
        self._asked = False
        node.create_service(AddTwoInts, "add_two_ints", self._add)
        if node.declare_parameter("one_shot", False).value:
            node.create_timer(0.1, self._end_if_asked)

    def _add(self, request: Any, response: Any) -> Any:
        self._node.get_logger().info(f"Incoming request\na: {request.a} b: {request.b}")
        response.sum = request.a + request.b
        self._asked = True
        return response

    def _end_if_asked(self) -> None:
        if self._asked:
            self._node.context.try_shutdown()


async def main(session: Session) -> int:
    return await run(session, ServerNode)
