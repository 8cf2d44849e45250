"""dummy_laser: a scan whose ranges all grow and shrink between 0 and 1 metre (dummy_sensors/src/dummy_laser.cpp)."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING

from sensor_msgs.msg import LaserScan

from day6_core.ros.programs._component import spin_cpp
from day6_core.ros.programs.rclcpp import create_node

if TYPE_CHECKING:
    from day6_core.session.session import Session

HERTZ = 30.0
STEP = 0.1
"""Radians of the sine's argument from one scan to the next."""
FIRST, LAST, RESOLUTION = -45.0, 225.0, 0.25
"""Degrees, of a Hokuyo laser scanner; both ends are measured."""


def scan() -> LaserScan:
    """Return the scan without its ranges' values."""
    message = LaserScan()
    message.header.frame_id = "single_rrbot_hokuyo_link"
    message.angle_increment = math.radians(RESOLUTION)
    message.angle_min = math.radians(FIRST) - math.pi / 2
    message.angle_max = math.radians(LAST) - math.pi / 2
    message.scan_time = 0.04
    message.range_max = 10.0
    message.ranges = [0.0] * (round((LAST - FIRST) / RESOLUTION) + 1)
    return message


async def main(session: Session) -> int:
    node = create_node(session, "dummy_laser")
    publisher = node.create_publisher(LaserScan, "scan", 10)
    message = scan()
    log = node.get_logger()
    log.info(f"angle inc:\t{message.angle_increment:f}")
    log.info(f"scan size:\t{len(message.ranges)}")
    log.info(f"scan time increment: \t{message.time_increment:f}")
    argument = 0.0

    def publish() -> None:
        nonlocal argument
        argument += STEP
        message.ranges = [abs(math.sin(argument))] * len(message.ranges)
        message.header.stamp = node.get_clock().now().to_msg()
        publisher.publish(message)

    node.create_timer(1 / HERTZ, publish)
    return await spin_cpp(session, node)
