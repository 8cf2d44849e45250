"""A timer's callback that asks when it was due, a partial, and one with a wrong argument."""

from functools import partial

import rclpy
from rclpy.timer import TimerInfo

rclpy.init()
node = rclpy.create_node("info")
seen = []


def with_info(info: TimerInfo):
    seen.append(info.actual_call_time >= info.expected_call_time)


def with_two(text, info: TimerInfo):
    seen.append(text)


first = node.create_timer(0.02, with_info)
second = node.create_timer(0.02, partial(with_two, "partial"))
while len(seen) < 4:
    rclpy.spin_once(node)
first.cancel()
second.cancel()
print(sorted(set(map(str, seen))))
node.create_timer(0.02, lambda needed: None)
try:
    rclpy.spin(node)
except TypeError as error:
    print("TypeError", error)
rclpy.shutdown()
