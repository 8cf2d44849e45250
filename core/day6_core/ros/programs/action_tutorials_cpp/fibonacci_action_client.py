"""fibonacci_action_client: asks for the sequence of order ten."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from action_msgs.msg import GoalStatus

from day6_core.ros.programs._component import ready
from day6_core.ros.programs.fibonacci_interface import Fibonacci, introspect, numbers_in
from day6_core.ros.programs.rclcpp import STOPPED, create_node, log_interrupt
from rclpy.action import ActionClient

if TYPE_CHECKING:
    from day6_core.session.session import Session

BEFORE, PATIENCE = 0.5, 10.0
ENDS = {GoalStatus.STATUS_ABORTED: "Goal was aborted", GoalStatus.STATUS_CANCELED: "Goal was canceled"}


async def main(session: Session) -> int:
    node = create_node(session, "fibonacci_action_client")
    client: ActionClient[Any, Any, Any] = ActionClient(node, Fibonacci, "fibonacci")
    introspect(node, "client", client)
    session.executor.add_node(node)
    logger = node.get_logger()
    try:
        await session.sleep(BEFORE)
        if not await ready(session, client.server_is_ready, PATIENCE):
            logger.error("Action server not available after waiting")
            return 0
        logger.info("Sending goal")

        def feedback(message: Any) -> None:
            logger.info(f"Next number in sequence received: {_numbers(numbers_in(message.feedback))}")

        sent: Any = client.send_goal_async(Fibonacci.Goal(order=10), feedback_callback=feedback)
        await session.spin_until(sent)
        if not sent.result().accepted:
            logger.error("Goal was rejected by server")
            await session.spin()
            return 0
        logger.info("Goal accepted by server, waiting for result")
        future = sent.result().get_result_async()
        await session.spin_until(future)
        if future.result().status != GoalStatus.STATUS_SUCCEEDED:
            logger.error(ENDS.get(future.result().status, "Unknown result code"))
            await session.spin()  # the original only ends when it succeeds
            return 0
        logger.info(f"Result received: {_numbers(future.result().result.sequence)}")
    except STOPPED:
        log_interrupt(session)
    return 0


def _numbers(sequence: Any) -> str:
    return "".join(f"{number} " for number in sequence)
