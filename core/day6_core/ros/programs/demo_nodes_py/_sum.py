"""Both clients of `add_two_ints`."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from example_interfaces.srv import AddTwoInts

from day6_core.ros.programs._waiting import wait_until

if TYPE_CHECKING:
    from day6_core.session.session import Session


async def ask(session: Session) -> int:
    """Wait for the service, request the sum of 2 and 3, log the response."""
    node = session.create_node("add_two_ints_client")
    client = node.create_client(AddTwoInts, "add_two_ints")
    session.executor.add_node(node)
    try:
        await wait_until(
            session, client.service_is_ready, lambda: session.print("service not available, waiting again...")
        )
        future: Any = client.call_async(AddTwoInts.Request(a=2, b=3))
        await session.spin_until(future)
    except KeyboardInterrupt:
        return 0
    if future.result() is not None:
        node.get_logger().info(f"Result of add_two_ints: {future.result().sum}")
    else:
        node.get_logger().error(f"Exception while calling service: {future.exception()!r}")
    return 0
