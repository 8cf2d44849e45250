"""Bytes of messages, raw subscriptions, publishing bytes."""

import rclpy
from rclpy.serialization import deserialize_message, serialize_message
from std_msgs.msg import Int32, String

data = serialize_message(String(data="abc"))
print(data, deserialize_message(data, String))
print(serialize_message(Int32(data=-2)))
rclpy.init()
node = rclpy.create_node("raw")
got = []
node.create_subscription(String, "words", got.append, 10, raw=True)
node.create_subscription(String, "words", lambda m: got.append(m), 10)
publisher = node.create_publisher(String, "words", 10)
while publisher.get_subscription_count() < 2:
    rclpy.spin_once(node, timeout_sec=0.01)
publisher.publish(String(data="raw"))
publisher.publish(serialize_message(String(data="bytes")))
while len(got) < 4:
    rclpy.spin_once(node, timeout_sec=0.5)
print(sorted(map(str, got)))
for wrong in ("text", 5, Int32()):
    try:
        publisher.publish(wrong)
    except TypeError as error:
        print("TypeError", error)
rclpy.shutdown()
