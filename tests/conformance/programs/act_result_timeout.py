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


def ex(gh):
    gh.succeed()
    return Fibonacci.Result(sequence=[3])


s = ActionServer(n, Fibonacci, "fib", ex, result_timeout=1)
c = ActionClient(n, Fibonacci, "fib")
c.wait_for_server()
f = c.send_goal_async(Fibonacci.Goal(order=1))
rclpy.spin_until_future_complete(n, f)
h = f.result()
r = h.get_result_async()
rclpy.spin_until_future_complete(n, r, timeout_sec=2)
print(r.result())
e = time.time() + 1.6
while time.time() < e:
    rclpy.spin_once(n, timeout_sec=0.1)
r = h.get_result_async()
rclpy.spin_until_future_complete(n, r, timeout_sec=2)
print(r.result())
r = h.cancel_goal_async()
rclpy.spin_until_future_complete(n, r, timeout_sec=2)
print(r.result())
rclpy.shutdown()
