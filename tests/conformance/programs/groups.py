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


from rclpy.callback_groups import *

g = MutuallyExclusiveCallbackGroup()
r = ReentrantCallbackGroup()
rclpy.init()
n = Node("n")
tm = n.create_timer(1, print, g)
tm2 = n.create_timer(1, print, r)
print(g.can_execute(tm), g.beginning_execution(tm), g.can_execute(tm), g.beginning_execution(tm))
g.ending_execution(tm)
print(g.can_execute(tm), g.has_entity(tm), g.has_entity(tm2), r.can_execute(tm2), len(g.entities))
t(lambda: CallbackGroup().can_execute(tm))
t(lambda: CallbackGroup().beginning_execution(tm))
t(lambda: n.create_timer(1, print, callback_group=5))
t(lambda: n.create_subscription(String, "c", print, 1, callback_group="x"))
rclpy.shutdown()
