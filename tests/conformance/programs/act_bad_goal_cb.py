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


def gcb(r):
    raise KeyError("no")


s = ActionServer(n, Fibonacci, "fib", lambda g: None, goal_callback=gcb)
c = ActionClient(n, Fibonacci, "fib")
c.wait_for_server()
f = c.send_goal_async(Fibonacci.Goal(order=1))
t(lambda: rclpy.spin_until_future_complete(n, f, timeout_sec=1))
print(f.done())
rclpy.shutdown()
