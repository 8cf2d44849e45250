"""Both clients of `add_two_ints`."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from example_interfaces.srv import AddTwoInts

from day6_core.ros.programs.demo_nodes_cpp._calls import wait_for_service
from day6_core.ros.programs.rclcpp import STOPPED, create_node, log_interrupt

if TYPE_CHECKING:
    from day6_core.session.session import Session


async def ask(session: Session) -> int:
    """Wait for the service, request the sum of 2 and 3, log the response."""
    node = create_node(session, "add_two_ints_client")
    client = node.create_client(AddTwoInts, "add_two_ints")
    if not await wait_for_service(session, node, client.service_is_ready):
        return 0
    session.executor.add_node(node)
    future: Any = client.call_async(AddTwoInts.Request(a=2, b=3))
    try:
        await session.spin_until(future)
    except STOPPED:
        log_interrupt(session)
        node.get_logger().error("Interrupted while waiting for response. Exiting.")
        return 0
    node.get_logger().info(f"Result of add_two_ints: {future.result().sum}")
    return 0
