"""A node on simulated time: its clock and its timer follow /clock."""

import rclpy
from rclpy.parameter import Parameter
from rosgraph_msgs.msg import Clock

rclpy.init()
node = rclpy.create_node("sim", parameter_overrides=[Parameter("use_sim_time", value=True)])
source = rclpy.create_node("clock_source")
publisher = source.create_publisher(Clock, "/clock", 10)
executor = rclpy.executors.SingleThreadedExecutor()
executor.add_node(node)
executor.add_node(source)
print(node.get_clock().now().nanoseconds, node.get_clock().ros_time_is_active)
ticks = []
node.create_timer(1.0, lambda: ticks.append(node.get_clock().now().nanoseconds))


def set_time(seconds):
    message = Clock()
    message.clock.sec = seconds
    publisher.publish(message)
    for _ in range(30):
        executor.spin_once(timeout_sec=0.01)
    print(seconds, node.get_clock().now().nanoseconds, len(ticks))


while publisher.get_subscription_count() == 0:
    executor.spin_once(timeout_sec=0.01)
for seconds in (1, 2, 2, 5, 6):
    set_time(seconds)
print(node.get_clock().now().to_msg())
rclpy.shutdown()
