"""Sends a goal, hears of its progress and waits for its result."""

from action_msgs.msg import GoalStatus
from example_interfaces.action import Fibonacci
from typing_extensions import assert_type

import rclpy
from rclpy.action import ActionClient
from rclpy.action.client import ClientGoalHandle
from rclpy.node import Node
from rclpy.task import Future
from rclpy.type_support import GetResultServiceResponse

Handle = ClientGoalHandle[Fibonacci.Goal, Fibonacci.Result, Fibonacci.Feedback]


class FibonacciActionClient(Node):
    def __init__(self) -> None:
        super().__init__("fibonacci_action_client")
        self.action_client = ActionClient(self, Fibonacci, "fibonacci")
        assert_type(self.action_client, ActionClient[Fibonacci.Goal, Fibonacci.Result, Fibonacci.Feedback])

    def send_goal(self, order: int) -> None:
        goal_msg = Fibonacci.Goal()
        goal_msg.order = order
        self.action_client.wait_for_server()
        future = self.action_client.send_goal_async(goal_msg, feedback_callback=self.feedback_callback)
        assert_type(future, Future[Handle])
        future.add_done_callback(self.goal_response_callback)

    def goal_response_callback(self, future: Future[Handle]) -> None:
        goal_handle = future.result()
        if goal_handle is None or not goal_handle.accepted:
            return
        goal_handle.get_result_async().add_done_callback(self.get_result_callback)

    def get_result_callback(self, future: Future[GetResultServiceResponse[Fibonacci.Result]]) -> None:
        answer = future.result()
        if answer is not None and answer.status == GoalStatus.STATUS_SUCCEEDED:
            assert_type(answer.result, Fibonacci.Result)
            self.get_logger().info(f"Result: {list(answer.result.sequence)}")

    def feedback_callback(self, feedback_msg: Fibonacci.Impl.FeedbackMessage) -> None:
        assert_type(feedback_msg.feedback, Fibonacci.Feedback)
        self.get_logger().info(f"{feedback_msg.feedback.sequence[-1]}")


def main() -> None:
    rclpy.init()
    action_client = FibonacciActionClient()
    action_client.send_goal(10)
    rclpy.spin(action_client)
