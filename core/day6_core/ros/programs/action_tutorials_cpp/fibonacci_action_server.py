"""fibonacci_action_server: computes the sequence, one number a second; orders above 46 would not fit and are refused."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from day6_core.ros.programs._component import run
from day6_core.ros.programs._waiting import pause
from day6_core.ros.programs.fibonacci_interface import Fibonacci, feedback_of, introspect
from rclpy.action import ActionServer, CancelResponse, GoalResponse

if TYPE_CHECKING:
    from day6_core.session.session import Session
    from rclpy.node import Node

HIGHEST_ORDER = 46


class FibonacciActionServer:
    """The action `fibonacci`."""

    NAME = "fibonacci_action_server"
    OPTIONS: dict[str, Any] = {}

    def __init__(self, node: Node) -> None:
        self._node = node
        self._info = node.get_logger().info
        self._server: ActionServer[Any, Any, Any] = ActionServer(
            node,
            Fibonacci,
            "fibonacci",
            self._execute,
            goal_callback=self._judge,
            cancel_callback=self._cancel,
        )
        introspect(node, "server", self._server)

    def _judge(self, goal: Any) -> GoalResponse:
        self._info(f"Received goal request with order {goal.order}")
        return GoalResponse.REJECT if goal.order > HIGHEST_ORDER else GoalResponse.ACCEPT

    def _cancel(self, handle: Any) -> CancelResponse:
        self._info("Received request to cancel goal")
        return CancelResponse.ACCEPT

    async def _execute(self, handle: Any) -> Any:
        self._info("Executing goal")
        sequence = [0, 1]
        for number in range(1, handle.request.order):
            if handle.is_cancel_requested:
                handle.canceled()
                self._info("Goal canceled")
                return Fibonacci.Result(sequence=sequence)
            sequence.append(sequence[number] + sequence[number - 1])
            handle.publish_feedback(feedback_of(sequence))
            self._info("Publish feedback")
            await pause(self._node, 1.0)
        handle.succeed()
        self._info("Goal succeeded")
        return Fibonacci.Result(sequence=sequence)


async def main(session: Session) -> int:
    return await run(session, FibonacciActionServer)
