"""mimic: drives one turtle with the velocities that another one reports (turtlesim/mimic.cpp).

Topics `input/pose` and `output/cmd_vel` are meant to be remapped. A pose reports speed without sign, so a turtle that
drives backward is mimicked forward, as in the original.
"""

from __future__ import annotations

from typing import TYPE_CHECKING

from geometry_msgs.msg import Twist

from day6_core.ros.programs.rclcpp import STOPPED, create_node, log_interrupt
from day6_core.ros.programs.turtlesim._qos import TOPIC_QOS
from day6_core.ros.programs.turtlesim_interfaces import Pose

if TYPE_CHECKING:
    from day6_core.session.session import Session


async def main(session: Session) -> int:
    node = create_node(session, "turtle_mimic")
    publisher = node.create_publisher(Twist, "output/cmd_vel", TOPIC_QOS)

    def repeat(pose: Pose) -> None:
        twist = Twist()
        twist.angular.z = pose.angular_velocity
        twist.linear.x = pose.linear_velocity
        publisher.publish(twist)

    node.create_subscription(Pose, "input/pose", repeat, TOPIC_QOS)
    try:
        await session.spin(node)
    except STOPPED:
        log_interrupt(session)
    return 0
