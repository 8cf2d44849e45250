"""A teleop that wants a terminal and has none says so with Python's own error."""

import sys
import termios

import rclpy

rclpy.init()
node = rclpy.create_node("teleop")
try:
    settings = termios.tcgetattr(sys.stdin)
except termios.error as error:
    node.get_logger().error(f"no terminal: {error.args[1]}")
node.destroy_node()
rclpy.shutdown()
sys.exit(3)
