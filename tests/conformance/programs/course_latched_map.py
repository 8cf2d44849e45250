"""A late joiner gets the last map."""

import rclpy
from nav_msgs.msg import OccupancyGrid
from rclpy.qos import DurabilityPolicy, QoSProfile

rclpy.init()
node = rclpy.create_node("map_server")
latched = QoSProfile(depth=1, durability=DurabilityPolicy.TRANSIENT_LOCAL)
publisher = node.create_publisher(OccupancyGrid, "map", latched)
for width in (2, 3):
    grid = OccupancyGrid()
    grid.header.frame_id = "map"
    grid.info.width, grid.info.height, grid.info.resolution = width, 1, 0.05
    grid.data = [0] * (width - 1) + [100]
    publisher.publish(grid)
maps = []
subscription = node.create_subscription(OccupancyGrid, "map", maps.append, latched)
while not maps:
    rclpy.spin_once(node, timeout_sec=0.1)
rclpy.spin_once(node, timeout_sec=0.1)
print(len(maps), maps[0].info.width, list(maps[0].data), maps[0].header.frame_id)
rclpy.shutdown()
