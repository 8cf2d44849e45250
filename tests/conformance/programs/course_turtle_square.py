"""The velocity commands of a square, without a turtle."""

import math

import rclpy
from geometry_msgs.msg import Twist
from rclpy.node import Node


class Square(Node):
    def __init__(self):
        super().__init__("square")
        self.publisher = self.create_publisher(Twist, "/turtle1/cmd_vel", 10)
        self.create_subscription(Twist, "/turtle1/cmd_vel", self.move, 10)
        self.x = self.y = self.heading = 0.0
        self.steps = 0
        self.timer = self.create_timer(0.01, self.step)

    def step(self):
        twist = Twist()
        if self.steps % 2 == 0:
            twist.linear.x = 2.0
        else:
            twist.angular.z = math.pi / 2
        self.publisher.publish(twist)
        self.steps += 1
        if self.steps == 8:
            self.timer.cancel()

    def move(self, twist):
        self.heading += twist.angular.z
        self.x += twist.linear.x * math.cos(self.heading)
        self.y += twist.linear.x * math.sin(self.heading)
        print(f"x={abs(self.x):.2f} y={abs(self.y):.2f} heading={math.degrees(self.heading):.0f}")


rclpy.init()
node = Square()
while node.steps < 8 or round(math.degrees(node.heading)) < 360:
    rclpy.spin_once(node)
print(node.timer.is_canceled())
node.destroy_node()
rclpy.shutdown()
