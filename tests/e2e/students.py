"""Programs as students type them from the lesson: the same classes, names, topics and rates, in words of our own."""

from __future__ import annotations

TALKER = """\
import rclpy
from rclpy.node import Node
from std_msgs.msg import String


class Talker(Node):
    def __init__(self):
        super().__init__('day6_talker')
        self.publisher_ = self.create_publisher(String, 'chatter', 10)
        self.timer = self.create_timer(0.5, self.timer_callback)
        self.count = 0

    def timer_callback(self):
        msg = String()
        msg.data = 'line %d of the talker' % self.count
        self.publisher_.publish(msg)
        self.get_logger().info('I said: %s' % msg.data)
        self.count += 1


def main(args=None):
    rclpy.init(args=args)
    node = Talker()
    rclpy.spin(node)
    node.destroy_node()
    rclpy.shutdown()


if __name__ == '__main__':
    main()
"""

WHEEL_SPINNER = """\
import math

import rclpy
from rclpy.node import Node
from sensor_msgs.msg import JointState


class WheelSpinner(Node):
    def __init__(self):
        super().__init__('wheel_spinner')
        self.publisher_ = self.create_publisher(JointState, 'joint_states', 10)
        self.timer = self.create_timer(0.02, self.timer_callback)
        self.angle = 0.0

    def timer_callback(self):
        msg = JointState()
        msg.header.stamp = self.get_clock().now().to_msg()
        msg.name = ['left_wheel_joint', 'right_wheel_joint']
        self.angle = (self.angle + 0.02) % (2 * math.pi)
        msg.position = [self.angle, self.angle]
        self.publisher_.publish(msg)


def main(args=None):
    rclpy.init(args=args)
    node = WheelSpinner()
    rclpy.spin(node)
    node.destroy_node()
    rclpy.shutdown()


if __name__ == '__main__':
    main()
"""

WRONG_NAMES = WHEEL_SPINNER.replace("left_wheel_joint", "wheel_left_joint").replace(
    "right_wheel_joint", "wheel_right_joint"
)
"""The commonest slip of the lesson."""

STUBBORN = """\
import signal
import time

signal.signal(signal.SIGINT, signal.SIG_IGN)
print('you cannot stop me', flush=True)
while True:
    time.sleep(1)
"""

ASKS = """\
name = input('Your name? ')
print(f'Hello {name}!')
"""
