"""fibonacci_action_server: computes the sequence, one number a second."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from day6_core.ros.programs._waiting import pause, spin
from day6_core.ros.programs.fibonacci_interface import Fibonacci, feedback_of, introspect, numbers_in
from rclpy.action import ActionServer

if TYPE_CHECKING:
    from day6_core.session.session import Session


async def main(session: Session) -> int:
    node = session.create_node("fibonacci_action_server")

    async def execute(handle: Any) -> Any:
        node.get_logger().info("Executing goal...")
        feedback = feedback_of([0, 1])
        sequence = numbers_in(feedback)
        for number in range(1, handle.request.order):
            sequence.append(sequence[number] + sequence[number - 1])
            node.get_logger().info(f"Feedback: {sequence}")
            handle.publish_feedback(feedback)
            await pause(node, 1.0)
        handle.succeed()
        return Fibonacci.Result(sequence=sequence)

    server: ActionServer[Any, Any, Any] = ActionServer(node, Fibonacci, "fibonacci", execute)
    session.defer(server.destroy)
    introspect(node, "server", server)
    return await spin(session, node)
