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
        self.declare_parameter("msg", "hello")
        self.p = self.create_publisher(String, "topic", 10)
        self.tm = self.create_timer(0.1, self.cb)
        self.i = 0

    def cb(self):
        m = String()
        m.data = f"{self.get_parameter('msg').value} {self.i}"
        self.p.publish(m)
        self.get_logger().info('Publishing: "%s"' % m.data)
        self.i += 1
        if self.i == 3:
            raise SystemExit


class S(Node):
    def __init__(self):
        super().__init__("sub")
        self.s = self.create_subscription(String, "topic", self.cb, 10)
        self.s

    def cb(self, m):
        self.get_logger().info('I heard: "%s"' % m.data)


def main():
    rclpy.init()
    p = P()
    s = S()
    ex = SingleThreadedExecutor()
    ex.add_node(p)
    ex.add_node(s)
    try:
        ex.spin()
    except SystemExit:
        print("exit")
    finally:
        ex.shutdown()
        p.destroy_node()
        s.destroy_node()
        rclpy.shutdown()


main()
