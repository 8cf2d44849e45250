import rclpy, time, threading
from rclpy.node import Node
from std_msgs.msg import String, Int32
from std_srvs.srv import SetBool, Trigger


def t(f):
    try:
        print("OK", repr(f()))
    except BaseException as e:
        print(type(e).__module__ + "." + type(e).__qualname__, "|", e)


rclpy.init()
n = Node("n")


def cb():
    n.destroy_node()
    print("destroyed")


n.create_timer(0.1, cb)
for i in range(3):
    t(lambda: rclpy.spin_once(n, timeout_sec=0.2))
t(lambda: n.get_name())
rclpy.shutdown()
