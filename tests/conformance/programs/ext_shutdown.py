import rclpy, time, threading
from rclpy.node import Node
from std_msgs.msg import String, Int32
from std_srvs.srv import SetBool, Trigger


def t(f):
    try:
        print("OK", repr(f()))
    except BaseException as e:
        print(type(e).__module__ + "." + type(e).__qualname__, "|", e)


from rclpy.executors import *

rclpy.init()
n = Node("n")
ex = SingleThreadedExecutor()
ex.add_node(n)
threading.Timer(0.2, rclpy.shutdown).start()
try:
    ex.spin()
    print("ret")
except BaseException as e:
    print(type(e).__name__)
