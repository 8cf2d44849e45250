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
ex = MultiThreadedExecutor(3)
ex.add_node(n)
r = n.create_rate(10)
out = []


def cb():
    tm.cancel()
    t0 = time.time()
    for i in range(3):
        r.sleep()
    out.append(0.15 < time.time() - t0 < 0.5)


tm = n.create_timer(0.05, cb, callback_group=ReentrantCallbackGroup())
th = threading.Thread(target=ex.spin, daemon=True)
th.start()
time.sleep(0.8)
print(out)
ex.shutdown()
rclpy.shutdown()
