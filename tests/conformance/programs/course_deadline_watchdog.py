"""A sensor falls silent: both sides are told."""

import time

import rclpy
from rclpy.duration import Duration
from rclpy.event_handler import PublisherEventCallbacks, SubscriptionEventCallbacks
from rclpy.qos import QoSProfile
from sensor_msgs.msg import Range

rclpy.init()
node = rclpy.create_node("watchdog")
qos = QoSProfile(depth=5, deadline=Duration(seconds=0.3))
events = []
publisher = node.create_publisher(
    Range,
    "sonar",
    qos,
    event_callbacks=PublisherEventCallbacks(
        deadline=lambda info: events.append(("offered", info.total_count, info.total_count_change))
    ),
)
node.create_subscription(
    Range,
    "sonar",
    lambda m: None,
    qos,
    event_callbacks=SubscriptionEventCallbacks(
        deadline=lambda info: events.append(("requested", info.total_count, info.total_count_change))
    ),
)


def spin(seconds):
    end = time.monotonic() + seconds
    while time.monotonic() < end:
        rclpy.spin_once(node, timeout_sec=0.01)


spin(0.5)
print("before the first message:", events)
publisher.publish(Range())
while min(sum(event[0] == side for event in events) for side in ("offered", "requested")) < 3:
    rclpy.spin_once(node, timeout_sec=0.01)
for side in ("offered", "requested"):
    print([event for event in events if event[0] == side][:3])
events.clear()
publisher.publish(Range())
spin(0.15)
print("just after a message:", events)
rclpy.shutdown()
