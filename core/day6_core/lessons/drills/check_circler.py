"""Whether the turtle of drill 34 goes on without a stop: its speed is watched for a moment."""

import sys
import time

import rclpy
from rclpy.executors import SingleThreadedExecutor
from rclpy.node import Node

try:
    from turtlesim_msgs.msg import Pose  # from Kilted on
except ModuleNotFoundError:
    from turtlesim.msg import Pose  # type: ignore[no-redef]

SECONDS = 0.5
ENOUGH = 15
"""Poses; a turtle tells 62 a second."""

STANDING = 0.1
"""Metres a second."""


def main() -> int:
    """Print what was seen; return 0 if the turtle never stood."""
    speeds: list[float] = []
    rclpy.init()
    node = Node("_day6_lesson_circler")
    node.create_subscription(Pose, "/turtle1/pose", lambda pose: speeds.append(abs(pose.linear_velocity)), 10)
    executor = SingleThreadedExecutor()
    executor.add_node(node)
    end = time.monotonic() + SECONDS
    while time.monotonic() < end:
        executor.spin_once(timeout_sec=0.1)
    node.destroy_node()
    rclpy.shutdown()
    standing = sum(speed < STANDING for speed in speeds)
    if len(speeds) < ENOUGH:
        print("没有海龟报告位置 (no turtle publishes its pose)")
    elif standing == len(speeds):
        print("海龟站着不动 (the turtle stands still)")
    elif standing:
        print("海龟走走停停 (the turtle stops and starts)")
    else:
        print("海龟一直在走 (the turtle keeps moving)")
    return 0 if len(speeds) >= ENOUGH and not standing else 1


if __name__ == "__main__":
    sys.exit(main())
