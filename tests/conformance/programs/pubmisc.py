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


rclpy.init()
n = Node("n")
p = n.create_publisher(String, "c", 10)
for v in (5, None, "x", String, Int32(), b"\x00\x01\x00\x00\x03\x00\x00\x00ab\x00", [String()]):
    t(lambda: p.publish(v))
t(lambda: p.publish(msg=String(data="q")))
t(lambda: p.publish(String(), String()))
t(lambda: p.get_subscription_count())
t(lambda: p.wait_for_all_acked())
t(lambda: p.wait_for_all_acked(Duration(seconds=1)))
print(repr(p)[:30], p.qos_profile.depth, p.msg_type)


class S2(String):
    pass


got = []
n.create_subscription(String, "c", lambda m: got.append(type(m)), 10)
time.sleep(0.3)
t(lambda: p.publish(S2(data="x")))
for i in range(3):
    rclpy.spin_once(n, timeout_sec=0.1)
print(got)
rclpy.shutdown()
