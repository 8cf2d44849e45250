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


def main():
    rclpy.init()
    n = Node("n")
    c = n.create_client(SetBool, "x")
    n.create_service(SetBool, "x", srv)
    c.wait_for_service()
    f = c.call_async(SetBool.Request())
    f.add_done_callback(cb)
    rclpy.spin(n)


def srv(q, r):
    r.success = True
    return r


def cb(f):
    raise RuntimeError("in done callback %s" % f.result().success)


main()
