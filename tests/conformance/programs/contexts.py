import rclpy, time, threading
from rclpy.node import Node
from std_msgs.msg import String, Int32
from std_srvs.srv import SetBool, Trigger


def t(f):
    try:
        print("OK", repr(f()))
    except BaseException as e:
        print(type(e).__module__ + "." + type(e).__qualname__, "|", e)


from rclpy.context import Context
from rclpy.executors import SingleThreadedExecutor

c = Context()
t(lambda: c.ok())
t(lambda: c.shutdown())
t(lambda: c.try_shutdown())
t(lambda: c.get_domain_id())
t(lambda: c.handle)
c.on_shutdown(lambda: print("bye"))
c.init(domain_id=7)
print(c.get_domain_id(), c.ok())
t(lambda: c.init())
n = Node("n", context=c)
ex = SingleThreadedExecutor(context=c)
ex.add_node(n)
ex.spin_once(timeout_sec=0.05)
t(lambda: Node("x"))
t(lambda: rclpy.ok())
t(lambda: rclpy.ok(context=c))
rclpy.shutdown(context=c)
t(lambda: c.ok())
t(lambda: c.shutdown())
c.on_shutdown(lambda: print("late"))
t(lambda: Context().init(domain_id=-1))
t(lambda: c.on_shutdown(5))
with Context() as d:
    print(d.ok())
print(d.ok())
e = Context()
with rclpy.init(context=e, domain_id=3) as i:
    print(type(i), i.context is e, e.get_domain_id())
print(e.ok())
import os

os.environ["ROS_DOMAIN_ID"] = "5"
f = Context()
f.init()
print(f.get_domain_id())
os.environ["ROS_DOMAIN_ID"] = "x"
t(lambda: Context().init())
rclpy.init(domain_id=2)
a = Node("a")
rclpy.try_shutdown()
t(lambda: rclpy.init())
os.environ["ROS_DOMAIN_ID"] = ""
t(lambda: rclpy.init())
