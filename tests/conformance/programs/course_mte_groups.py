"""Two slow callbacks side by side, or one after the other."""

import threading
import time

import rclpy
from rclpy.callback_groups import MutuallyExclusiveCallbackGroup, ReentrantCallbackGroup
from rclpy.executors import MultiThreadedExecutor


def most_at_once(*groups):
    node = rclpy.create_node("groups")
    lock = threading.Lock()
    running = most = ended = 0

    def slow():
        nonlocal running, most, ended
        with lock:
            running += 1
            most = max(most, running)
        time.sleep(0.15)
        with lock:
            running -= 1
            ended += 1

    timers = [node.create_timer(0.05, slow, callback_group=group) for group in groups]
    executor = MultiThreadedExecutor(num_threads=4)
    executor.add_node(node)
    end = time.monotonic() + 0.6
    while time.monotonic() < end:
        executor.spin_once(timeout_sec=0.05)
    for timer in timers:
        timer.cancel()
    time.sleep(0.3)
    executor.shutdown()
    node.destroy_node()
    return most


rclpy.init()
one = MutuallyExclusiveCallbackGroup()
print("the same exclusive group:", most_at_once(one, one))
print("two exclusive groups:", most_at_once(MutuallyExclusiveCallbackGroup(), MutuallyExclusiveCallbackGroup()))
print("a reentrant group runs more than one:", most_at_once(ReentrantCallbackGroup()) > 1)
rclpy.shutdown()
