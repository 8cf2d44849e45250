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
ns = [Node("n%d" % i) for i in range(5)]
from rclpy.executors import *

ex = SingleThreadedExecutor()
[ex.add_node(x) for x in ns]
got = []
[x.create_subscription(String, "/c", lambda m, i=i: got.append(i), 10) for i, x in enumerate(ns)]
p = ns[0].create_publisher(String, "/c", 10)
time.sleep(0.5)
p.publish(String())
for i in range(7):
    ex.spin_once(timeout_sec=0.1)
print(sorted(got))
ns[1].destroy_node()
p.publish(String())
got.clear()
for i in range(7):
    ex.spin_once(timeout_sec=0.1)
print(sorted(got))
ex.remove_node(ns[2])
p.publish(String())
got.clear()
for i in range(7):
    ex.spin_once(timeout_sec=0.1)
print(sorted(got))
ex.add_node(ns[2])
for i in range(3):
    ex.spin_once(timeout_sec=0.1)
print(sorted(got))
rclpy.shutdown()
