"""turtle_tf2_message_broadcaster: a third turtle that drives in a circle and publishes its position as a point."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from geometry_msgs.msg import PointStamped, Twist

from day6_core.ros.programs._waiting import spin
from day6_core.ros.programs.turtle_tf2_py.frames import Spawner
from day6_core.ros.programs.turtlesim_interfaces import Pose

if TYPE_CHECKING:
    from day6_core.session.session import Session
    from rclpy.node import Node

NAME = "turtle3"


class PointTeller:
    """Spawns the turtle; when it is there, answers each of its poses with a speed and a point."""

    def __init__(self, node: Node) -> None:
        self._node = node
        self._spawner = Spawner(node, NAME)
        self._speeds: Any = None
        self._points: Any = None
        node.create_timer(1.0, self._step)

    def _step(self) -> None:
        if not self._spawner.done:
            self._spawner.step()
        elif self._speeds is None:
            self._speeds = self._node.create_publisher(Twist, f"{NAME}/cmd_vel", 10)
            self._points = self._node.create_publisher(PointStamped, f"{NAME}/turtle_point_stamped", 10)
            self._node.create_subscription(Pose, f"{NAME}/pose", self._on_pose, 10)

    def _on_pose(self, pose: Pose) -> None:
        twist = Twist()
        twist.linear.x = twist.angular.z = 1.0
        self._speeds.publish(twist)
        point = PointStamped()
        point.header.stamp = self._node.get_clock().now().to_msg()
        point.header.frame_id = "world"
        point.point.x, point.point.y = pose.x, pose.y
        self._points.publish(point)


async def main(session: Session) -> int:
    node = session.create_node("turtle_tf2_message_broadcaster")
    PointTeller(node)
    return await spin(session, node)
