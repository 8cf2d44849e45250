"""A long goal is cancelled while it runs in another thread."""

import time

import rclpy
from rclpy.action import ActionClient, ActionServer, CancelResponse, GoalResponse
from rclpy.callback_groups import ReentrantCallbackGroup
from rclpy.executors import MultiThreadedExecutor
from test_msgs.action import Fibonacci

rclpy.init()
node = rclpy.create_node("cancelled")
group = ReentrantCallbackGroup()


ended = []


def execute(goal_handle):
    for _ in range(500):
        if goal_handle.is_cancel_requested:
            goal_handle.canceled()
            ended.append("server: canceled")
            return Fibonacci.Result(sequence=[1, 2, 3])
        time.sleep(0.01)
    goal_handle.succeed()
    return Fibonacci.Result()


server = ActionServer(
    node,
    Fibonacci,
    "slow",
    execute,
    callback_group=group,
    goal_callback=lambda goal: GoalResponse.ACCEPT if goal.order > 0 else GoalResponse.REJECT,
    cancel_callback=lambda handle: CancelResponse.ACCEPT,
)
client = ActionClient(node, Fibonacci, "slow", callback_group=group)
executor = MultiThreadedExecutor(4)
executor.add_node(node)
client.wait_for_server()


def wait(future):
    executor.spin_until_future_complete(future, timeout_sec=10)
    return future.result()


print("rejected:", wait(client.send_goal_async(Fibonacci.Goal(order=0))).accepted)
handle = wait(client.send_goal_async(Fibonacci.Goal(order=5)))
print("accepted:", handle.accepted)
answer = wait(handle.cancel_goal_async())
print("cancel:", answer.return_code, len(answer.goals_canceling))
result = wait(handle.get_result_async())
print(ended)
print("result:", result.status, list(result.result.sequence))
executor.shutdown()
rclpy.shutdown()
