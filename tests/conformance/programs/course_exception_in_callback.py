"""An exception in a callback ends spin, with the program's own traceback."""

import rclpy
from rclpy.node import Node


class Fragile(Node):
    def __init__(self):
        super().__init__("fragile")
        self.readings = [3, 2, 1]
        self.create_timer(0.01, self.tick)

    def tick(self):
        value = self.readings.pop()
        self.get_logger().info(f"reading {value}")
        return 10 / (value - 2)


rclpy.init()
rclpy.spin(Fragile())
print("never printed")
