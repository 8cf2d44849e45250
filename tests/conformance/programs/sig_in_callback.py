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


def cb():
    os.kill(os.getpid(), signal.SIGINT)
    time.sleep(0.2)
    print("not reached")


n.create_timer(0.1, cb)
try:
    rclpy.spin(n)
except KeyboardInterrupt:
    print("KI")
