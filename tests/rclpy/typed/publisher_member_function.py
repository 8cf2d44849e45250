"""Publishes text twice a second, as the first tutorial does."""

from std_msgs.msg import String
from typing_extensions import assert_type

import rclpy
from rclpy.node import Node
from rclpy.publisher import Publisher
from rclpy.timer import Timer


class MinimalPublisher(Node):
    def __init__(self) -> None:
        super().__init__("minimal_publisher")
        self.publisher_ = self.create_publisher(String, "topic", 10)
        assert_type(self.publisher_, Publisher[String])
        self.timer = self.create_timer(0.5, self.timer_callback)
        assert_type(self.timer, Timer)
        self.i = 0

    def timer_callback(self) -> None:
        msg = String()
        msg.data = f"Hello World: {self.i}"
        assert_type(msg.data, str)
        self.publisher_.publish(msg)
        self.get_logger().info(f'Publishing: "{msg.data}"', throttle_duration_sec=1.0)
        self.i += 1


def main(args: list[str] | None = None) -> None:
    rclpy.init(args=args)
    minimal_publisher = MinimalPublisher()
    rclpy.spin(minimal_publisher)
    minimal_publisher.destroy_node()
    rclpy.shutdown()
