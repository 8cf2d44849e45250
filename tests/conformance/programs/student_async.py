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


class N(Node):
    def __init__(self):
        super().__init__("n")
        g = ReentrantCallbackGroup()
        self.c = self.create_client(SetBool, "x", callback_group=g)
        self.create_service(SetBool, "x", self.srv)
        self.create_timer(0.1, self.tick, callback_group=g)

    def srv(self, q, r):
        r.message = "m"
        return r

    async def tick(self):
        r = await self.c.call_async(SetBool.Request())
        print(r.message)
        raise ZeroDivisionError


rclpy.init()
n = N()
try:
    rclpy.spin(n)
except ZeroDivisionError as e:
    print("caught")
