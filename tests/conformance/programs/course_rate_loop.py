"""A loop paced by a Rate, spun in a thread."""

import threading

import rclpy
from rclpy.executors import ExternalShutdownException

rclpy.init()
node = rclpy.create_node("paced")


def spin():
    try:
        rclpy.spin(node)
    except ExternalShutdownException:
        pass


thread = threading.Thread(target=spin, daemon=True)
thread.start()
rate = node.create_rate(50)
start = node.get_clock().now()
for _ in range(10):
    rate.sleep()
elapsed = (node.get_clock().now() - start).nanoseconds / 1e9
print("ten ticks at 50 Hz take about 0.2 s:", 0.17 < elapsed < 0.4)
try:
    node.create_rate(0)
except ValueError as error:
    print("ValueError:", error)
node.destroy_rate(rate)
try:
    rate.sleep()
except Exception as error:
    print(type(error).__name__, error)
rclpy.shutdown()
thread.join(3)
