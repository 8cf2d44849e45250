"""Check of drill 13: whether the board hears the school's station, and nobody else."""

import sys
import time

import rclpy
from rclpy.node import Node

SECONDS = 0.6
STRING = "std_msgs/msg/String"
STATION = "/school/station"


def heard(node: Node) -> set[str]:
    """The nodes that the board hears, by their full names."""
    found: set[str] = set()
    for topic, types in node.get_topic_names_and_types():
        if STRING in types and any(each.node_name == "board" for each in node.get_subscriptions_info_by_topic(topic)):
            speakers = node.get_publishers_info_by_topic(topic)
            found.update(f"{each.node_namespace.rstrip('/')}/{each.node_name}" for each in speakers)
    return found


def main() -> int:
    """Print what was seen; return 0 if it is the school's station alone."""
    rclpy.init()
    node = Node("_day6_lesson_board")
    end = time.monotonic() + SECONDS
    while STATION not in (nodes := heard(node)) and time.monotonic() < end:
        time.sleep(0.05)
    node.destroy_node()
    rclpy.shutdown()
    if nodes == {STATION}:
        print(f"公告牌听到了 {STATION} (the board hears {STATION})")
        return 0
    if nodes:
        names = ", ".join(sorted(nodes))
        print(f"公告牌听到的是 {names} (the board hears {names})")
    else:
        print("公告牌什么也没听到 (the board hears nobody)")
    return 1


if __name__ == "__main__":
    sys.exit(main())
