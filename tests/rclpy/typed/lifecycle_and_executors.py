"""A lifecycle node beside tasks, groups, guards, rates and waiting for one message."""

from sensor_msgs.msg import LaserScan
from typing_extensions import assert_type

import rclpy
from rclpy.callback_groups import MutuallyExclusiveCallbackGroup, ReentrantCallbackGroup
from rclpy.executors import ExternalShutdownException, MultiThreadedExecutor
from rclpy.lifecycle import LifecycleNode, LifecyclePublisher, LifecycleState, TransitionCallbackReturn
from rclpy.node import Node
from rclpy.task import Future, Task
from rclpy.wait_for_message import wait_for_message


class Camera(LifecycleNode):
    def on_configure(self, state: LifecycleState) -> TransitionCallbackReturn:
        self.publisher = self.create_lifecycle_publisher(LaserScan, "scan", 10)
        assert_type(self.publisher, LifecyclePublisher[LaserScan])
        return super().on_configure(state)


async def measure(scale: float) -> float:
    done: Future[float] = Future()
    done.set_result(scale)
    return await done or 0.0


def main() -> None:
    rclpy.init()
    node = Node("tools", parameter_overrides=[])
    node.create_timer(0.1, lambda: None, callback_group=ReentrantCallbackGroup())
    node.create_guard_condition(lambda: None, MutuallyExclusiveCallbackGroup())
    executor = MultiThreadedExecutor(num_threads=2)
    executor.add_node(node)
    executor.add_node(Camera("camera"))
    task = executor.create_task(measure, 2.0)
    assert_type(task, Task[float])
    executor.spin_until_future_complete(task, timeout_sec=1.0)
    found, scan = wait_for_message(LaserScan, node, "scan", time_to_wait=1.0)
    assert_type(scan, LaserScan | None)
    if found and scan is not None:
        node.get_logger().info(f"{scan.ranges[0] + scan.angle_min}")
    try:
        executor.spin()
    except (KeyboardInterrupt, ExternalShutdownException):
        node.get_logger().warning("end")
