"""Tells where a turtle is."""

from geometry_msgs.msg import TransformStamped
from tf2_ros import TransformBroadcaster
from turtlesim.msg import Pose
from typing_extensions import assert_type

import rclpy
from rclpy.node import Node


class FramePublisher(Node):
    def __init__(self) -> None:
        super().__init__("turtle_tf2_frame_publisher")
        self.turtlename = str(self.declare_parameter("turtlename", "turtle").value)
        self.tf_broadcaster = TransformBroadcaster(self)
        self.subscription = self.create_subscription(Pose, f"/{self.turtlename}/pose", self.handle_turtle_pose, 1)

    def handle_turtle_pose(self, msg: Pose) -> None:
        t = TransformStamped()
        t.header.stamp = self.get_clock().now().to_msg()
        t.header.frame_id = "world"
        t.child_frame_id = self.turtlename
        t.transform.translation.x = msg.x
        assert_type(t.transform.translation.x, float)
        t.transform.rotation.w = 1.0
        self.tf_broadcaster.sendTransform(t)


def main() -> None:
    rclpy.init()
    rclpy.spin(FramePublisher())
