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


import signal, os

rclpy.init()
n = Node("n")
p = n.create_publisher(String, "x", 1)
threading.Timer(0.4, lambda: os.kill(os.getpid(), signal.SIGTERM)).start()
k = 0
while rclpy.ok():
    p.publish(String(data="a"))
    time.sleep(0.1)
    k += 1
print(k >= 3)
n.destroy_node()
rclpy.shutdown()
print("end")
