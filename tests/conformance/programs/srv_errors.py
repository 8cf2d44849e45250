import rclpy, time, threading
from rclpy.node import Node
from std_msgs.msg import String, Int32
from std_srvs.srv import SetBool, Trigger
from rclpy.action import *
from rclpy.executors import *
from rclpy.callback_groups import *
from test_msgs.action import Fibonacci


def t(f):
    try:
        print("OK", repr(f()))
    except BaseException as e:
        print(type(e).__module__ + "." + type(e).__qualname__, "|", e)


rclpy.init()
n = Node("n")


def boom(q, r):
    raise IndexError("srv")


n.create_service(SetBool, "a", boom)
c = n.create_client(SetBool, "a")
c.wait_for_service()
f = c.call_async(SetBool.Request())
t(lambda: rclpy.spin_until_future_complete(n, f, timeout_sec=0.5))
print(f.done())
d = n.create_client(Trigger, "b")
f = d.call_async(Trigger.Request())
f.cancel()
t(lambda: rclpy.spin_until_future_complete(n, f, timeout_sec=0.3))
print(f.cancelled(), len(d._pending_requests))
f = d.call_async(Trigger.Request())
print(d.get_pending_request(2) is f)
t(lambda: d.get_pending_request(99))
d.remove_pending_request(f)
t(lambda: d.get_pending_request(2))
n.destroy_client(d)
t(lambda: d.call_async(Trigger.Request()))
t(lambda: d.service_is_ready())
s2 = n.create_service(Trigger, "two", lambda q, r: r)
s3 = n.create_service(Trigger, "two", lambda q, r: r)
e = n.create_client(Trigger, "two")
e.wait_for_service()
f = e.call_async(Trigger.Request())
rclpy.spin_until_future_complete(n, f, timeout_sec=1)
print(f.result())
for i in range(5):
    rclpy.spin_once(n, timeout_sec=0.05)
print(n.destroy_service(s2), n.destroy_service(s2), s3.service_name)
rclpy.shutdown()
