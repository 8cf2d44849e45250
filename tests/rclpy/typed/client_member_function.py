"""Asks for a sum."""

import sys

from example_interfaces.srv import AddTwoInts
from typing_extensions import assert_type

import rclpy
from rclpy.client import Client
from rclpy.node import Node
from rclpy.task import Future


class MinimalClientAsync(Node):
    def __init__(self) -> None:
        super().__init__("minimal_client_async")
        self.cli = self.create_client(AddTwoInts, "add_two_ints")
        assert_type(self.cli, Client[AddTwoInts.Request, AddTwoInts.Response])
        while not self.cli.wait_for_service(timeout_sec=1.0):
            self.get_logger().info("service not available, waiting again...")
        self.req = AddTwoInts.Request()

    def send_request(self, a: int, b: int) -> Future[AddTwoInts.Response]:
        self.req.a = a
        self.req.b = b
        future = self.cli.call_async(self.req)
        future.add_done_callback(self.answered)
        return future

    def answered(self, future: Future[AddTwoInts.Response]) -> None:
        response = future.result()
        assert_type(response, AddTwoInts.Response | None)


def main() -> None:
    rclpy.init()
    minimal_client = MinimalClientAsync()
    future = minimal_client.send_request(int(sys.argv[1]), int(sys.argv[2]))
    rclpy.spin_until_future_complete(minimal_client, future)
    response = future.result()
    if response is not None:
        minimal_client.get_logger().info(f"Result: {response.sum}")
    rclpy.shutdown()
