"""Whether the windmill's sail of drill 43 turns: the transforms are watched for a moment."""

import itertools
import math
import sys
import time

from tf2_msgs.msg import TFMessage

import rclpy
from rclpy.executors import SingleThreadedExecutor
from rclpy.node import Node

SECONDS = 0.7
ENOUGH = 0.3
"""Radians in that time; the wind turns the sail by 2 a second."""


def main() -> int:
    """Print what was seen; return 0 if the sail turned."""
    angles: list[float] = []

    def take(message: TFMessage) -> None:
        for transform in message.transforms:
            if transform.child_frame_id == "sail":
                rotation = transform.transform.rotation
                angles.append(2 * math.atan2(rotation.x, rotation.w))

    rclpy.init()
    node = Node("_day6_lesson_windmill")
    node.create_subscription(TFMessage, "/tf", take, 50)
    executor = SingleThreadedExecutor()
    executor.add_node(node)
    end = time.monotonic() + SECONDS
    while time.monotonic() < end:
        executor.spin_once(timeout_sec=0.1)
    node.destroy_node()
    rclpy.shutdown()
    turned = sum(abs(math.remainder(b - a, 2 * math.pi)) for a, b in itertools.pairwise(angles))
    if not angles:
        print("没有人知道叶片在哪里 (nobody publishes where the sail is)")
    elif turned < ENOUGH:
        print("叶片不动 (the sail stands still)")
    else:
        print("叶片在转 (the sail turns)")
    return 0 if turned >= ENOUGH else 1


if __name__ == "__main__":
    sys.exit(main())
