"""Frames as messages on /tf: a chain is put together by hand."""

import math

import rclpy
from geometry_msgs.msg import TransformStamped

rclpy.init()
node = rclpy.create_node("frames")
edges = {}
node.create_subscription(TransformStamped, "/frames", lambda t: edges.__setitem__(t.child_frame_id, t), 10)
publisher = node.create_publisher(TransformStamped, "/frames", 10)
while publisher.get_subscription_count() == 0:
    rclpy.spin_once(node, timeout_sec=0.01)
for parent, child, x, yaw in (
    ("map", "odom", 1.0, 0.0),
    ("odom", "base", 2.0, math.pi / 2),
    ("base", "laser", 0.5, 0.0),
):
    t = TransformStamped()
    t.header.stamp = node.get_clock().now().to_msg()
    t.header.frame_id, t.child_frame_id = parent, child
    t.transform.translation.x = x
    t.transform.rotation.z, t.transform.rotation.w = math.sin(yaw / 2), math.cos(yaw / 2)
    publisher.publish(t)
while len(edges) < 3:
    rclpy.spin_once(node, timeout_sec=0.5)


def pose(frame):
    if frame == "map":
        return 0.0, 0.0, 0.0
    edge = edges[frame]
    x, y, yaw = pose(edge.header.frame_id)
    dx, dy = edge.transform.translation.x, edge.transform.translation.y
    turn = 2 * math.atan2(edge.transform.rotation.z, edge.transform.rotation.w)
    return x + dx * math.cos(yaw) - dy * math.sin(yaw), y + dx * math.sin(yaw) + dy * math.cos(yaw), yaw + turn


for frame in ("odom", "base", "laser"):
    print(frame, " ".join(f"{value:.3f}" for value in pose(frame)))
rclpy.shutdown()
