import rclpy, time, threading, functools
from rclpy.node import Node
from rclpy.qos import *
from rclpy.duration import Duration
from std_msgs.msg import String, Int32
from std_srvs.srv import SetBool, Trigger


def t(f):
    try:
        print("OK", repr(f()))
    except BaseException as e:
        print(type(e).__module__ + "." + type(e).__qualname__, "|", e)


from rclpy.event_handler import *

rclpy.init()
n = Node("n")
for a, b in (
    (dict(deadline=Duration(seconds=2)), dict(deadline=Duration(seconds=1))),
    (
        dict(liveliness=LivelinessPolicy.AUTOMATIC, liveliness_lease_duration=Duration(seconds=2)),
        dict(liveliness=LivelinessPolicy.MANUAL_BY_TOPIC, liveliness_lease_duration=Duration(seconds=3)),
    ),
    (dict(), dict(deadline=Duration(seconds=1))),
    (dict(liveliness_lease_duration=Duration(seconds=2)), dict(liveliness_lease_duration=Duration(seconds=1))),
    (dict(reliability=2, durability=2), dict(reliability=1, durability=1)),
):
    k = "t%d" % len(list(n.publishers))
    p = n.create_publisher(String, k, QoSProfile(depth=1, **a))
    s = n.create_subscription(String, k, print, QoSProfile(depth=1, **b))
    for i in range(3):
        rclpy.spin_once(n, timeout_sec=0.1)
    print(k, p.get_subscription_count(), s.get_publisher_count())
for x in n.get_publishers_info_by_topic("t1") + n.get_subscriptions_info_by_topic("t2"):
    print(x.qos_profile)
print(qos_policy_name_from_kind(16))
t(lambda: qos_policy_name_from_kind(3))
t(lambda: n.create_publisher(String, "z", qos_profile_system_default).qos_profile)
t(
    lambda: (
        n.create_publisher(
            String, "z", QoSProfile(depth=1, reliability=ReliabilityPolicy.BEST_AVAILABLE)
        ).qos_profile.reliability
    )
)
rclpy.shutdown()
