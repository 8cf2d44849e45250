"""Adds two numbers for whoever asks."""

from example_interfaces.srv import AddTwoInts
from typing_extensions import assert_type

import rclpy
from rclpy.node import Node
from rclpy.service import Service


class MinimalService(Node):
    def __init__(self) -> None:
        super().__init__("minimal_service")
        self.srv = self.create_service(AddTwoInts, "add_two_ints", self.add_two_ints_callback)
        assert_type(self.srv, Service[AddTwoInts.Request, AddTwoInts.Response])
        self.create_service(AddTwoInts, "add_slowly", self.add_slowly)

    def add_two_ints_callback(self, request: AddTwoInts.Request, response: AddTwoInts.Response) -> AddTwoInts.Response:
        response.sum = request.a + request.b
        assert_type(response.sum, int)
        return response

    async def add_slowly(self, request: AddTwoInts.Request, response: AddTwoInts.Response) -> AddTwoInts.Response:
        return self.add_two_ints_callback(request, response)


def main() -> None:
    rclpy.init()
    rclpy.spin(MinimalService())
    rclpy.shutdown()
