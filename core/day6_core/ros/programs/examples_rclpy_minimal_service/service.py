"""service: adds two numbers, in the original written with functions."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from example_interfaces.srv import AddTwoInts

from day6_core.ros.programs._waiting import spin

if TYPE_CHECKING:
    from day6_core.session.session import Session


async def main(session: Session) -> int:
    return await serve_sums(session, "minimal_service")


async def serve_sums(session: Session, name: str) -> int:
    """Add two numbers for whoever asks, by a node of that name."""
    node = session.create_node(name)

    def add(request: Any, response: Any) -> Any:
        response.sum = request.a + request.b
        node.get_logger().info(f"Incoming request\na: {request.a} b: {request.b}")
        return response

    node.create_service(AddTwoInts, "add_two_ints", add)
    return await spin(session, node)
