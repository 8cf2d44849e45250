"""Hears text, with and without what is known of each message."""

from std_msgs.msg import String
from typing_extensions import assert_type

import rclpy
from rclpy.node import Node
from rclpy.qos import DurabilityPolicy, QoSProfile
from rclpy.subscription import MessageInfo, Subscription


class MinimalSubscriber(Node):
    def __init__(self) -> None:
        super().__init__("minimal_subscriber")
        self.subscription = self.create_subscription(String, "topic", self.listener_callback, 10)
        assert_type(self.subscription, Subscription[String])
        latched = QoSProfile(depth=1, durability=DurabilityPolicy.TRANSIENT_LOCAL)
        self.create_subscription(String, "latched", self.informed_callback, latched)
        self.create_subscription(String, "topic", lambda message: assert_type(message, String), 10)

    def listener_callback(self, msg: String) -> None:
        self.get_logger().info(f'I heard: "{msg.data}"')

    def informed_callback(self, msg: String, info: MessageInfo) -> None:
        self.get_logger().info(f"{msg.data} at {info['source_timestamp']}", once=True)


def main() -> None:
    with rclpy.init():
        rclpy.spin(MinimalSubscriber())
