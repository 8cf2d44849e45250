"""The newer way: init as a context manager, nodes too, ending by itself."""

import rclpy
from rclpy.executors import ExternalShutdownException
from rclpy.node import Node
from std_msgs.msg import Int8


class Countdown(Node):
    def __init__(self, start):
        super().__init__("countdown")
        self.left = start
        self.publisher = self.create_publisher(Int8, "left", 10)
        self.create_timer(0.01, self.tick)

    def tick(self):
        self.get_logger().info(f"{self.left}")
        self.publisher.publish(Int8(data=self.left))
        self.left -= 1
        if self.left < 0:
            raise SystemExit


def main():
    try:
        with rclpy.init():
            with Countdown(3) as node:
                try:
                    rclpy.spin(node)
                except SystemExit:
                    print("lift-off", rclpy.ok())
        print("after the block", rclpy.ok())
    except (KeyboardInterrupt, ExternalShutdownException):
        print("interrupted")


main()
