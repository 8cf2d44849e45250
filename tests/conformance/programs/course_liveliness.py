"""A publisher has to say that it lives, and then does not."""

import time

import rclpy
from rclpy.duration import Duration
from rclpy.event_handler import PublisherEventCallbacks, SubscriptionEventCallbacks
from rclpy.qos import LivelinessPolicy, QoSProfile
from std_msgs.msg import Bool

rclpy.init()
node = rclpy.create_node("alive")
qos = QoSProfile(depth=5, liveliness=LivelinessPolicy.MANUAL_BY_TOPIC, liveliness_lease_duration=Duration(seconds=0.4))
publisher = node.create_publisher(
    Bool,
    "beat",
    qos,
    event_callbacks=PublisherEventCallbacks(
        liveliness=lambda info: print("lost", info.total_count, info.total_count_change)
    ),
)
node.create_subscription(
    Bool,
    "beat",
    lambda m: print("beat", m.data),
    qos,
    event_callbacks=SubscriptionEventCallbacks(
        liveliness=lambda info: print(
            "alive",
            info.alive_count,
            info.alive_count_change,
            "not alive",
            info.not_alive_count,
            info.not_alive_count_change,
        )
    ),
)


def spin(seconds):
    end = time.monotonic() + seconds
    while time.monotonic() < end:
        rclpy.spin_once(node, timeout_sec=0.01)


spin(0.7)
print("first sign of life")
publisher.assert_liveliness()
spin(0.2)
publisher.assert_liveliness()
spin(0.2)
print("a message")
publisher.publish(Bool(data=True))
spin(0.3)
print("destroyed")
node.destroy_publisher(publisher)
spin(0.3)
rclpy.shutdown()
