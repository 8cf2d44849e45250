"""draw_square: resets turtlesim and drives turtle1 along a square for ever (turtlesim/draw_square.cpp)."""

from __future__ import annotations

from typing import TYPE_CHECKING

from geometry_msgs.msg import Twist
from std_srvs.srv import Empty

from day6_core.ros.programs.rclcpp import STOPPED, create_node, log_interrupt
from day6_core.ros.programs.turtlesim import model
from day6_core.ros.programs.turtlesim._qos import TOPIC_QOS
from day6_core.ros.programs.turtlesim_interfaces import Pose

if TYPE_CHECKING:
    from day6_core.session.session import Session

PERIOD = 0.016  # seconds


async def main(session: Session) -> int:
    node = create_node(session, "draw_square")
    publisher = node.create_publisher(Twist, "turtle1/cmd_vel", TOPIC_QOS)
    square = model.Square()
    latest: list[Pose] = []

    def remember(pose: Pose) -> None:
        latest[:] = [pose]

    def drive() -> None:
        if not latest:
            return
        command, lines = square.decide(
            model.Pose(*(getattr(latest[0], field) for field in model.Pose._fields)),
        )
        for line in lines:
            node.get_logger().info(line)
        if command is not None:
            twist = Twist()
            twist.linear.x, twist.angular.z = command
            publisher.publish(twist)

    node.create_subscription(Pose, "turtle1/pose", remember, TOPIC_QOS)
    # Like the original it only waits for the request to be on its way, not for the answer.
    node.create_client(Empty, "reset").call_async(Empty.Request())
    node.create_timer(PERIOD, drive)
    try:
        await session.spin(node)
    except STOPPED:
        log_interrupt(session)
    return 0
