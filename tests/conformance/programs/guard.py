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
o = []


async def ag():
    o.append("a")


g = n.create_guard_condition(lambda: o.append("g"))
h = n.create_guard_condition(ag)
g.trigger()
g.trigger()
h.trigger()
for i in range(4):
    rclpy.spin_once(n, timeout_sec=0.05)
print(o)
threading.Timer(0.2, g.trigger).start()
t0 = time.time()
rclpy.spin_once(n, timeout_sec=2)
print(o, 0.1 < time.time() - t0 < 1)
print(n.destroy_guard_condition(g), n.destroy_guard_condition(g))
t(lambda: g.trigger())
print(len(list(n.guards)))
rclpy.shutdown()
