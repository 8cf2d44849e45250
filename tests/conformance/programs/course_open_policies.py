"""Profiles that leave policies open: what endpoints really get, and who hears whom."""

import time

import rclpy
from rclpy.duration import Duration
from rclpy.qos import (
    DurabilityPolicy,
    HistoryPolicy,
    LivelinessPolicy,
    QoSProfile,
    ReliabilityPolicy,
    qos_profile_best_available,
    qos_profile_sensor_data,
    qos_profile_system_default,
)
from std_msgs.msg import String

rclpy.init()
node = rclpy.create_node("open")
PLAIN = QoSProfile(depth=10)
LATCHED = QoSProfile(depth=10, durability=DurabilityPolicy.TRANSIENT_LOCAL)
STRICT = QoSProfile(
    depth=10,
    deadline=Duration(seconds=2),
    liveliness=LivelinessPolicy.MANUAL_BY_TOPIC,
    liveliness_lease_duration=Duration(seconds=3),
)
HISTORY = QoSProfile(depth=0, history=HistoryPolicy.SYSTEM_DEFAULT)
RELIABILITY = QoSProfile(depth=10, reliability=ReliabilityPolicy.SYSTEM_DEFAULT)
SYSTEM, BEST, SENSOR = qos_profile_system_default, qos_profile_best_available, qos_profile_sensor_data


def wait(seconds):
    end = time.monotonic() + seconds
    while time.monotonic() < end:
        rclpy.spin_once(node, timeout_sec=0.02)


def told(info):
    qos = info.qos_profile
    names = [qos.reliability.name, qos.durability.name, qos.liveliness.name]
    return [*names, str(qos.deadline), str(qos.liveliness_lease_duration), str(qos.lifespan)]


def meet(topic, offer, request, *, subscription_first=False):
    heard = []

    def subscribe():
        return node.create_subscription(String, topic, lambda message: heard.append(message.data), request)

    subscription = subscribe() if subscription_first else None
    publisher = node.create_publisher(String, topic, offer)
    publisher.publish(String(data="before"))
    wait(0.1)
    subscription = subscription or subscribe()
    wait(0.15)
    publisher.publish(String(data="after"))
    wait(0.15)
    print(topic, heard)
    print("  offered", *(told(info) for info in node.get_publishers_info_by_topic(topic)))
    print("  requested", *(told(info) for info in node.get_subscriptions_info_by_topic(topic)))
    node.destroy_publisher(publisher)
    node.destroy_subscription(subscription)


meet("/system_to_system", SYSTEM, SYSTEM)
meet("/system_to_plain", SYSTEM, PLAIN)
meet("/system_to_latched", SYSTEM, LATCHED)
meet("/sensor_to_system", SENSOR, SYSTEM)
meet("/sensor_to_open_reliability", SENSOR, RELIABILITY)
meet("/latched_to_system", LATCHED, SYSTEM)
meet("/open_history", HISTORY, HISTORY)
meet("/sensor_to_best", SENSOR, BEST)
meet("/plain_to_best", PLAIN, BEST)
meet("/latched_to_best", LATCHED, BEST)
meet("/strict_to_best", STRICT, BEST)
meet("/best_to_best", BEST, BEST)
meet("/best_to_latched", BEST, LATCHED)
meet("/best_after_strict", BEST, STRICT, subscription_first=True)
meet("/best_waits_for_latched", LATCHED, BEST, subscription_first=True)
