"""dummy_map_server: a map of unknown cells through which one wall wanders (dummy_map_server/src/dummy_map_server.cpp)."""

from __future__ import annotations

from typing import TYPE_CHECKING

from nav_msgs.msg import OccupancyGrid

from day6_core.ros.programs._component import spin_cpp
from day6_core.ros.programs.rclcpp import create_node
from rclpy.qos import DurabilityPolicy, QoSProfile

if TYPE_CHECKING:
    from day6_core.session.session import Session

SIDE = 100
"""Cells."""
RESOLUTION = 0.1
"""Metres of a cell's side."""
UNKNOWN, FREE, OCCUPIED = -1, 0, 100


def empty_map() -> OccupancyGrid:
    """Return a square around the origin of `world`, all of it unknown."""
    grid = OccupancyGrid()
    grid.header.frame_id = "world"
    grid.info.resolution = RESOLUTION
    grid.info.width = grid.info.height = SIDE
    grid.info.origin.position.x = grid.info.origin.position.y = -SIDE * RESOLUTION / 2
    grid.info.origin.orientation.w = 1.0
    grid.data = [UNKNOWN] * SIDE * SIDE
    return grid


async def main(session: Session) -> int:
    node = create_node(session, "dummy_map_server")
    lasting = QoSProfile(depth=1, durability=DurabilityPolicy.TRANSIENT_LOCAL)
    publisher = node.create_publisher(OccupancyGrid, "map", lasting)
    grid = empty_map()
    first = 0

    def publish() -> None:
        nonlocal first
        for cell in range(first, first + 3):
            grid.data[cell % len(grid.data)] = UNKNOWN
        first += 1
        for cell, value in enumerate((FREE, OCCUPIED, FREE), first):
            grid.data[cell % len(grid.data)] = value
        grid.header.stamp = node.get_clock().now().to_msg()
        publisher.publish(grid)

    publish()
    node.create_timer(1.0, publish)
    return await spin_cpp(session, node)
