"""add_two_ints_server: adds two numbers for whoever asks."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from example_interfaces.srv import AddTwoInts

from day6_tui.core.ros.programs._waiting import spin

if TYPE_CHECKING:
    from day6_tui.core.session.session import Session


async def main(session: Session) -> int:
    node = session.create_node("add_two_ints_server")

    def add(request: Any, response: Any) -> Any:
        response.sum = request.a + request.b
        node.get_logger().info(f"Incoming request\na: {request.a} b: {request.b}")
        return response

    node.create_service(AddTwoInts, "add_two_ints", add)
    return await spin(session, node)
