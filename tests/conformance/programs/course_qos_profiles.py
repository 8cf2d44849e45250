"""Which publishers and subscriptions find each other."""

import rclpy
from rclpy.qos import DurabilityPolicy, HistoryPolicy, QoSProfile, ReliabilityPolicy, qos_profile_sensor_data
from std_msgs.msg import Int32

rclpy.init()
node = rclpy.create_node("qos")
got = []
profiles = {
    "reliable": QoSProfile(depth=10, reliability=ReliabilityPolicy.RELIABLE),
    "best effort": QoSProfile(depth=10, reliability=ReliabilityPolicy.BEST_EFFORT),
    "latched": QoSProfile(depth=1, durability=DurabilityPolicy.TRANSIENT_LOCAL),
    "sensor": qos_profile_sensor_data,
    "all": QoSProfile(history=HistoryPolicy.KEEP_ALL),
}
for i, (offer, offered) in enumerate(profiles.items()):
    for j, (wish, wanted) in enumerate(profiles.items()):
        topic = f"t_{i}_{j}"
        publisher = node.create_publisher(
            Int32,
            topic,
            offered,
            event_callbacks=rclpy.event_handler.PublisherEventCallbacks(use_default_callbacks=False),
        )
        subscription = node.create_subscription(
            Int32,
            topic,
            got.append,
            wanted,
            event_callbacks=rclpy.event_handler.SubscriptionEventCallbacks(use_default_callbacks=False),
        )
        for _ in range(20):
            if publisher.get_subscription_count():
                break
            rclpy.spin_once(node, timeout_sec=0.01)
        print(f"{offer} -> {wish}:", publisher.get_subscription_count())
        node.destroy_publisher(publisher)
        node.destroy_subscription(subscription)
rclpy.shutdown()
