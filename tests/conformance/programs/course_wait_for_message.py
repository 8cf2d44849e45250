"""Waiting for one message, and not getting one."""

import threading
import time

import rclpy
from rclpy.wait_for_message import wait_for_message
from std_msgs.msg import Float32

rclpy.init()
node = rclpy.create_node("waiter")
publisher = node.create_publisher(Float32, "value", 10)
print(wait_for_message(Float32, node, "value", time_to_wait=0.2))


def later():
    while publisher.get_subscription_count() == 0:
        time.sleep(0.01)
    publisher.publish(Float32(data=2.5))


thread = threading.Thread(target=later)
thread.start()
print(wait_for_message(Float32, node, "value", time_to_wait=5.0))
thread.join()
print(node.wait_for_node("waiter", 1.0), node.wait_for_node("nobody", 0.2))
rclpy.shutdown()
