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


class P(Node):
    def __init__(self):
        super().__init__("pub")
        self.create_subscription(String, "topic", self.cb, 10)
        self.p = self.create_publisher(String, "topic", 10)
        self.create_timer(0.1, self.tick)

    def tick(self):
        self.p.publish(String(data="x"))

    def cb(self, m):
        print(m.daat)


def main():
    rclpy.init()
    n = P()
    rclpy.spin(n)
    rclpy.shutdown()


main()
