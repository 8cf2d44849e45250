"""Other right ways to solve the days, for tests to hand in: closed loops, streams of commands, nodes without classes."""

from __future__ import annotations

from tests.grading.article import INNER

STAR_BY_POSE = """\
import math

import rclpy
from geometry_msgs.msg import Twist
from rclpy.node import Node
from turtlesim.msg import Pose


class Star(Node):

    def __init__(self):
        super().__init__('star')
        self.keys = self.create_publisher(Twist, '/turtle1/cmd_vel', 10)
        self.create_subscription(Pose, '/turtle1/pose', self.steer, 10)
        self.corners = None
        self.done = False

    def plan(self, pose):
        x, y, heading = pose.x, pose.y, pose.theta
        self.corners = []
        for side in range(5):
            x, y = x + 2.5 * math.cos(heading), y + 2.5 * math.sin(heading)
            self.corners.append((x, y))
            heading += math.radians(144)

    def steer(self, pose):
        if self.corners is None:
            self.plan(pose)
        x, y = self.corners[0]
        far = math.hypot(x - pose.x, y - pose.y)
        order = Twist()
        if far < 0.03:
            self.corners.pop(0)
            self.done = not self.corners
        else:
            off = math.remainder(math.atan2(y - pose.y, x - pose.x) - pose.theta, 2 * math.pi)
            order.angular.z = 4.0 * off
            if abs(off) < 0.05:
                order.linear.x = min(1.5, 2.0 * far)
        self.keys.publish(order)


rclpy.init()
star = Star()
while not star.done:
    rclpy.spin_once(star)
"""

STAR_BY_STREAM = """\
import time

import rclpy
from geometry_msgs.msg import Twist

rclpy.init()
node = rclpy.create_node('star')
keys = node.create_publisher(Twist, '/turtle1/cmd_vel', 10)
while keys.get_subscription_count() == 0:
    time.sleep(0.1)


def drive(ahead, turn, seconds):
    end = time.monotonic() + seconds
    while time.monotonic() < end:
        order = Twist()
        order.linear.x = ahead
        order.angular.z = turn
        keys.publish(order)
        time.sleep(0.05)
    keys.publish(Twist())
    time.sleep(0.3)


for side in range(5):
    drive(1.5, 0.0, 2.0)
    drive(0.0, 1.2566, 2.0)
"""

TALKER = """\
import time

import rclpy
from std_msgs.msg import String


def main():
    rclpy.init()
    node = rclpy.create_node('talker')
    mouth = node.create_publisher(String, 'chatter', 10)
    number = 0
    while rclpy.ok():
        number += 1
        mouth.publish(String(data=str(number)))
        rclpy.spin_once(node, timeout_sec=0)
        time.sleep(0.4)
"""

LISTENER = """\
import rclpy
from std_msgs.msg import String


def main():
    rclpy.init()
    node = rclpy.create_node('listener')
    node.create_subscription(String, 'chatter', lambda note: print(note.data, flush=True), 10)
    while rclpy.ok():
        rclpy.spin_once(node, timeout_sec=0.2)
"""

SPINNER = """\
import math

import rclpy
from rclpy.node import Node
from sensor_msgs.msg import JointState


class Spinner(Node):

    def __init__(self):
        super().__init__('wheel_spinner')
        self.out = self.create_publisher(JointState, 'joint_states', 10)
        self.began = self.get_clock().now()
        self.create_timer(0.05, self.turn)

    def turn(self):
        now = self.get_clock().now()
        angle = math.remainder((now - self.began).nanoseconds * 1e-9 * 1.5, 2 * math.pi)
        state = JointState(name=['left_wheel_joint', 'right_wheel_joint'], position=[angle, -angle])
        state.header.stamp = now.to_msg()
        self.out.publish(state)


def main():
    rclpy.init()
    rclpy.spin(Spinner())
"""

OTHERWISE: dict[str, tuple[tuple[str, ...], dict[str, str | None]]] = {
    "by the pose": (
        ("day3", "day4", "day5", "day6"),
        {
            "home/star.py": STAR_BY_POSE,
            f"{INNER}talker.py": TALKER,
            f"{INNER}listener.py": LISTENER,
            f"{INNER}wheel_spinner.py": SPINNER,
        },
    ),
    "by a stream of commands": (("day3",), {"home/star.py": STAR_BY_STREAM}),
}
"""Submissions that are right: the lessons they are for, and the files in which they differ from the good one."""
