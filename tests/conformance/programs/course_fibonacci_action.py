"""An action with feedback and result, step by step."""

import rclpy
from rclpy.action import ActionClient, ActionServer
from rclpy.node import Node
from test_msgs.action import Fibonacci


class Server(Node):
    def __init__(self):
        super().__init__("fibonacci_server")
        self.server = ActionServer(self, Fibonacci, "fibonacci", self.execute)

    def execute(self, goal_handle):
        self.get_logger().info("Executing goal...")
        feedback = Fibonacci.Feedback()
        feedback.sequence = [0, 1]
        for i in range(1, goal_handle.request.order):
            feedback.sequence.append(feedback.sequence[i] + feedback.sequence[i - 1])
            goal_handle.publish_feedback(feedback)
        goal_handle.succeed()
        result = Fibonacci.Result()
        result.sequence = feedback.sequence
        return result


class Client(Node):
    def __init__(self):
        super().__init__("fibonacci_client")
        self.client = ActionClient(self, Fibonacci, "fibonacci")
        self.done = rclpy.task.Future()

    def send(self, order):
        goal = Fibonacci.Goal()
        goal.order = order
        self.client.wait_for_server()
        self.client.send_goal_async(goal, feedback_callback=self.on_feedback).add_done_callback(self.on_response)

    def on_feedback(self, message):
        print("feedback", list(message.feedback.sequence))

    def on_response(self, future):
        handle = future.result()
        print("accepted", handle.accepted)
        handle.get_result_async().add_done_callback(self.on_result)

    def on_result(self, future):
        print("status", future.result().status, "result", list(future.result().result.sequence))
        self.done.set_result(True)


rclpy.init()
server, client = Server(), Client()
executor = rclpy.executors.SingleThreadedExecutor()
executor.add_node(server)
executor.add_node(client)
client.send(6)
executor.spin_until_future_complete(client.done, timeout_sec=10)
rclpy.shutdown()
