import rclpy, time, threading
from rclpy.node import Node
from std_msgs.msg import String, Int32
from std_srvs.srv import SetBool, Trigger


def t(f):
    try:
        print("OK", repr(f()))
    except BaseException as e:
        print(type(e).__module__ + "." + type(e).__qualname__, "|", e)


from rclpy.event_handler import *
from rclpy.qos import *

rclpy.init()
n = Node("n")
p = n.create_publisher(
    String,
    "c",
    10,
    event_callbacks=PublisherEventCallbacks(
        matched=lambda e: print("P", e.total_count, e.total_count_change, e.current_count, e.current_count_change)
    ),
)
for i in range(2):
    rclpy.spin_once(n, timeout_sec=0.1)
s = n.create_subscription(
    String,
    "c",
    print,
    10,
    event_callbacks=SubscriptionEventCallbacks(
        matched=lambda e: print("S", e.total_count, e.total_count_change, e.current_count, e.current_count_change)
    ),
)
for i in range(4):
    rclpy.spin_once(n, timeout_sec=0.1)
n.destroy_subscription(s)
for i in range(4):
    rclpy.spin_once(n, timeout_sec=0.1)
print(len(p.event_handlers), type(p.event_handlers[0]).__name__, p.event_handlers[0].event_type)
x = n.create_publisher(
    String,
    "d",
    QoSProfile(depth=1, reliability=2),
    event_callbacks=PublisherEventCallbacks(use_default_callbacks=False),
)
y = n.create_subscription(String, "d", print, 10)
for i in range(4):
    rclpy.spin_once(n, timeout_sec=0.1)
print(x.event_handlers)
rclpy.shutdown()
