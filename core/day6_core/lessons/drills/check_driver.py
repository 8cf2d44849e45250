"""Check of drill 12: whether /turtlesim hears what /driver publishes."""

import sys
import time

import rclpy
from rclpy.node import Node

SECONDS = 0.6
TWIST = "geometry_msgs/msg/Twist"


def connected(node: Node) -> bool:
    """Whether some topic goes from the one to the other."""
    for topic, types in node.get_topic_names_and_types():
        if TWIST in types:
            speakers = {info.node_name for info in node.get_publishers_info_by_topic(topic)}
            listeners = {info.node_name for info in node.get_subscriptions_info_by_topic(topic)}
            if "driver" in speakers and "turtlesim" in listeners:
                return True
    return False


def main() -> int:
    """Print what was seen; return 0 if it does."""
    rclpy.init()
    node = Node("_day6_lesson_driver")
    end = time.monotonic() + SECONDS
    while not (found := connected(node)) and time.monotonic() < end:
        time.sleep(0.05)
    node.destroy_node()
    rclpy.shutdown()
    if found:
        print("海龟听到了 /driver (the turtle hears /driver)")
        return 0
    print("海龟没有听到 /driver (the turtle does not hear /driver)")
    return 1


if __name__ == "__main__":
    sys.exit(main())
