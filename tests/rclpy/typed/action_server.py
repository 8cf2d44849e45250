"""Computes Fibonacci numbers, with feedback, cancelling and refusing."""

from example_interfaces.action import Fibonacci
from typing_extensions import assert_type

import rclpy
from rclpy.action import ActionServer, CancelResponse, GoalResponse
from rclpy.action.server import ServerGoalHandle
from rclpy.node import Node

Goal = ServerGoalHandle[Fibonacci.Goal, Fibonacci.Result, Fibonacci.Feedback]


class FibonacciActionServer(Node):
    def __init__(self) -> None:
        super().__init__("fibonacci_action_server")
        self.action_server = ActionServer(
            self,
            Fibonacci,
            "fibonacci",
            self.execute_callback,
            goal_callback=self.goal_callback,
            cancel_callback=self.cancel_callback,
        )
        assert_type(self.action_server, ActionServer[Fibonacci.Goal, Fibonacci.Result, Fibonacci.Feedback])

    def goal_callback(self, goal: Fibonacci.Goal) -> GoalResponse:
        return GoalResponse.ACCEPT if goal.order < 50 else GoalResponse.REJECT

    def cancel_callback(self, goal_handle: Goal) -> CancelResponse:
        return CancelResponse.ACCEPT if goal_handle.is_active else CancelResponse.REJECT

    async def execute_callback(self, goal_handle: Goal) -> Fibonacci.Result:
        sequence = [0, 1]
        for _ in range(1, goal_handle.request.order):
            if goal_handle.is_cancel_requested:
                goal_handle.canceled()
                return Fibonacci.Result()
            sequence.append(sequence[-1] + sequence[-2])
            goal_handle.publish_feedback(Fibonacci.Feedback(sequence=sequence))
        goal_handle.succeed()
        assert_type(goal_handle.request, Fibonacci.Goal)
        return Fibonacci.Result(sequence=sequence)


def main() -> None:
    rclpy.init()
    rclpy.spin(FibonacciActionServer())
