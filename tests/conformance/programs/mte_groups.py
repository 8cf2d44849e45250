import rclpy, time, threading
from rclpy.node import Node
from std_msgs.msg import String, Int32
from std_srvs.srv import SetBool, Trigger


def t(f):
    try:
        print("OK", repr(f()))
    except BaseException as e:
        print(type(e).__module__ + "." + type(e).__qualname__, "|", e)


from rclpy.executors import MultiThreadedExecutor
from rclpy.callback_groups import *

rclpy.init()
n = Node("n")
out = []


def slow(name):
    def cb():
        out.append(name + " in")
        time.sleep(0.35)
        out.append(name + " out")

    return cb


g = MutuallyExclusiveCallbackGroup()
r = ReentrantCallbackGroup()
a = n.create_timer(0.2, slow("A"), g)
b = n.create_timer(0.21, slow("B"), r)
ex = MultiThreadedExecutor(4)
ex.add_node(n)
th = threading.Thread(target=ex.spin, daemon=True)
th.start()
time.sleep(0.9)
ex.shutdown()
print(out[:6])
print(g.has_entity(a), r.has_entity(a), n.default_callback_group.has_entity(b))
rclpy.shutdown()
