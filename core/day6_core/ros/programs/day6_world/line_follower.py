"""`ros2 run day6_world line_follower`: follows the line seen by /line_sensor, driving with /cmd_vel.

An example to read and to improve: it steers by how far the dark part lies to the left or right (a P controller), and
where it lost the line it turns to the side where it saw it last. Parameters: `speed` (m/s), `gain` (rad/s).
"""

from __future__ import annotations

from typing import TYPE_CHECKING

from geometry_msgs.msg import Twist
from std_msgs.msg import Float32MultiArray

if TYPE_CHECKING:
    from day6_core.session.session import Session
    from rclpy.node import Node


class LineFollower:
    """The node: one velocity for every reading of the sensor."""

    def __init__(self, node: Node) -> None:
        self._node = node
        node.declare_parameter("speed", 0.2)
        node.declare_parameter("gain", 1.5)
        self._side = 0.0
        """Where the line was seen last: 1 far left, -1 far right."""
        self._publisher = node.create_publisher(Twist, "cmd_vel", 10)
        node.create_subscription(Float32MultiArray, "line_sensor", self._steer, 10)

    def _steer(self, message: Float32MultiArray) -> None:
        seen = message.data
        dark = sum(seen)
        if dark > 0.1:
            places = [1 - 2 * index / max(len(seen) - 1, 1) for index in range(len(seen))]
            self._side = sum(place * value for place, value in zip(places, seen, strict=True)) / dark
        speed, gain = (float(self._node.get_parameter(name).value) for name in ("speed", "gain"))
        twist = Twist()
        # Slower in curves; without a line it turns on the spot until it sees one again.
        twist.linear.x = speed * (1 - 0.5 * abs(self._side)) if dark > 0.1 else 0.0
        twist.angular.z = gain * (self._side if dark > 0.1 else 0.6 * (1 if self._side >= 0 else -1))
        self._publisher.publish(twist)

    def stop(self) -> None:
        self._publisher.publish(Twist())


async def main(session: Session) -> int:
    node = session.create_node("line_follower")
    follower = LineFollower(node)
    try:
        await session.spin(node)
    except KeyboardInterrupt:
        return 0
    finally:
        follower.stop()  # however it ends: otherwise the world keeps executing the last command
    return 0
