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
a = Node("a")
b = Node("b")
out = []
a.create_timer(0.1, lambda: out.append("a"))
b.create_timer(0.1, lambda: out.append("b"))
while min(out.count("a"), out.count("b")) < 3:
    rclpy.spin_once(a, timeout_sec=0.05)
    rclpy.spin_once(b, timeout_sec=0.05)
print(sorted(set(out)))
t(lambda: rclpy.spin_once(a, executor=SingleThreadedExecutor(), timeout_sec=0.01))
ex = SingleThreadedExecutor()
rclpy.spin_until_future_complete(a, ex.create_task(lambda: 5), executor=ex, timeout_sec=1)
rclpy.shutdown()
