"""A slow listener: only the newest messages are kept."""

import time

import rclpy
from rclpy.event_handler import SubscriptionEventCallbacks
from std_msgs.msg import Int32

rclpy.init()
node = rclpy.create_node("slow")
got, lost = [], []
publisher = node.create_publisher(Int32, "fast", 50)
node.create_subscription(
    Int32,
    "fast",
    lambda m: got.append(m.data),
    3,
    event_callbacks=SubscriptionEventCallbacks(message_lost=lambda i: lost.append(i.total_count)),
)
while publisher.get_subscription_count() == 0:
    rclpy.spin_once(node, timeout_sec=0.01)
for number in range(20):
    publisher.publish(Int32(data=number))
time.sleep(0.2)
for _ in range(30):
    rclpy.spin_once(node, timeout_sec=0.01)
print(got, lost)
rclpy.shutdown()
