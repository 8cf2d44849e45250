"""fibonacci_action_client: asks for the sequence of order ten."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from day6_core.ros.programs.fibonacci_interface import Fibonacci, introspect, numbers_in
from rclpy.action import ActionClient

if TYPE_CHECKING:
    from day6_core.session.session import Session


async def main(session: Session) -> int:
    node = session.create_node("fibonacci_action_client")
    client: ActionClient[Any, Any, Any] = ActionClient(node, Fibonacci, "fibonacci")
    introspect(node, "client", client)
    session.executor.add_node(node)
    info = node.get_logger().info

    def feedback(message: Any) -> None:
        info(f"Received feedback: {numbers_in(message.feedback)}")

    try:
        while not client.server_is_ready():
            await session.sleep(0.02)
        sent: Any = client.send_goal_async(Fibonacci.Goal(order=10), feedback_callback=feedback)
        await session.spin_until(sent)
        if not sent.result().accepted:
            info("Goal rejected :(")
            await session.spin()
            return 0
        info("Goal accepted :)")
        future = sent.result().get_result_async()
        await session.spin_until(future)
    except KeyboardInterrupt:
        return 0
    info(f"Result: {future.result().result.sequence}")
    return 0
