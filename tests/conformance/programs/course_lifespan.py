"""Messages that are not worth hearing after a while."""

import time

import rclpy
from rclpy.duration import Duration
from rclpy.qos import DurabilityPolicy, QoSProfile
from std_msgs.msg import String

rclpy.init()
node = rclpy.create_node("short_lived")
latched = dict(depth=10, durability=DurabilityPolicy.TRANSIENT_LOCAL)
publisher = node.create_publisher(String, "news", QoSProfile(lifespan=Duration(seconds=0.3), **latched))
publisher.publish(String(data="old"))
time.sleep(0.5)
publisher.publish(String(data="new"))
got = []
node.create_subscription(String, "news", lambda m: got.append(m.data), QoSProfile(**latched))
for _ in range(20):
    rclpy.spin_once(node, timeout_sec=0.01)
print("a late joiner gets", got)
reader = rclpy.create_node("reader")
other = node.create_publisher(String, "plain", 10)
reader.create_subscription(
    String, "plain", lambda m: got.append(m.data), QoSProfile(depth=10, lifespan=Duration(seconds=0.2))
)
while other.get_subscription_count() == 0:
    time.sleep(0.01)
got.clear()
other.publish(String(data="stale"))
time.sleep(0.4)
other.publish(String(data="fresh"))
for _ in range(20):
    rclpy.spin_once(reader, timeout_sec=0.01)
print("a subscription with a lifespan gets", got)
rclpy.shutdown()
