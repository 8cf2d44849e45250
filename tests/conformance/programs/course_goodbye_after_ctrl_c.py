"""What courses print when Ctrl-C came: a last line of the node's logger, of its child, of a logger without node."""

import os
import signal
import threading

import rclpy
from rclpy.node import Node


class Patrol(Node):
    def __init__(self):
        super().__init__("patrol")
        self.wheels = self.get_logger().get_child("wheels")
        self.create_timer(0.1, self.drive)

    def drive(self):
        self.get_logger().info("driving", once=True)


rclpy.init()
node = Patrol()
threading.Timer(0.5, os.kill, (os.getpid(), signal.SIGINT)).start()
try:
    rclpy.spin(node)
except KeyboardInterrupt:
    node.get_logger().info("patrol is over")
    node.wheels.warning("wheels stop")
    node.get_logger().debug("not shown")
    rclpy.logging.get_logger("somebody").error("no node of mine")
finally:
    node.destroy_node()
    node.get_logger().info("destroyed")
    if rclpy.ok():
        rclpy.shutdown()
