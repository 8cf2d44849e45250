"""Follows a turtle by its frame."""

import math

from geometry_msgs.msg import TransformStamped, Twist
from tf2_ros import TransformException
from tf2_ros.buffer import Buffer
from tf2_ros.transform_listener import TransformListener
from turtlesim.srv import Spawn
from typing_extensions import assert_type

import rclpy
from rclpy.duration import Duration
from rclpy.node import Node
from rclpy.time import Time


class FrameListener(Node):
    def __init__(self) -> None:
        super().__init__("turtle_tf2_frame_listener")
        self.target_frame = self.declare_parameter("target_frame", "turtle1").get_parameter_value().string_value
        self.tf_buffer = Buffer()
        self.tf_listener = TransformListener(self.tf_buffer, self)
        self.spawner = self.create_client(Spawn, "spawn")
        self.publisher = self.create_publisher(Twist, "turtle2/cmd_vel", 1)
        self.timer = self.create_timer(1.0, self.on_timer)

    def on_timer(self) -> None:
        try:
            t = self.tf_buffer.lookup_transform("turtle2", self.target_frame, Time(), timeout=Duration(seconds=1.0))
        except TransformException as ex:
            self.get_logger().info(f"Could not transform turtle2 to {self.target_frame}: {ex}")
            return
        assert_type(t, TransformStamped)
        msg = Twist()
        msg.angular.z = math.atan2(t.transform.translation.y, t.transform.translation.x)
        msg.linear.x = 0.5 * math.hypot(t.transform.translation.x, t.transform.translation.y)
        self.publisher.publish(msg)


def main() -> None:
    rclpy.init()
    rclpy.spin(FrameListener())
