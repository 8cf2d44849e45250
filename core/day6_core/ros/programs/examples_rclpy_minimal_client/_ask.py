"""All four clients: from outside they differ in their names and in when they send the request."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from example_interfaces.srv import AddTwoInts

from day6_core.ros.programs._waiting import wait_until

if TYPE_CHECKING:
    from day6_core.session.session import Session


async def ask(session: Session, name: str, *, pause: float = 0.0) -> int:
    """Wait for the server, then `pause` seconds, request the sum of 41 and 1 and log the response."""
    node = session.create_node(name)
    client = node.create_client(AddTwoInts, "add_two_ints")
    session.executor.add_node(node)
    info = node.get_logger().info
    request = AddTwoInts.Request(a=41, b=1)
    try:
        await wait_until(session, client.service_is_ready, lambda: info("service not available, waiting again..."))
        await session.sleep(pause)
        future: Any = client.call_async(request)
        await session.spin_until(future)
    except KeyboardInterrupt:
        return 0
    info(f"Result of add_two_ints: for {request.a} + {request.b} = {future.result().sum}")
    return 0
