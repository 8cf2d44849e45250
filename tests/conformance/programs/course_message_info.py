"""What a callback learns about a message beside its content."""

import rclpy
from std_msgs.msg import String

rclpy.init()
node = rclpy.create_node("info")
publisher = node.create_publisher(String, "t", 10)
infos = []
node.create_subscription(String, "t", lambda msg, info: infos.append(info), 10)
while publisher.get_subscription_count() == 0:
    rclpy.spin_once(node, timeout_sec=0.01)
for text in "ab":
    publisher.publish(String(data=text))
while len(infos) < 2:
    rclpy.spin_once(node, timeout_sec=0.5)
first, second = infos
print(sorted(first))
print(first["publication_sequence_number"], second["publication_sequence_number"], first["reception_sequence_number"])
print(first["received_timestamp"] >= first["source_timestamp"] > 0)
print(
    first["publisher_gid"] == second["publisher_gid"],
    first["publisher_gid"]["implementation_identifier"],
    len(first["publisher_gid"]["data"]),
)
rclpy.shutdown()
