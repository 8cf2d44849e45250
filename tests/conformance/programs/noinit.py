import rclpy, time, threading, functools
from rclpy.node import Node
from rclpy.qos import *
from rclpy.duration import Duration
from std_msgs.msg import String, Int32
from std_srvs.srv import SetBool, Trigger


def t(f):
    try:
        print("OK", repr(f()))
    except BaseException as e:
        print(type(e).__module__ + "." + type(e).__qualname__, "|", e)


t(lambda: Node("n"))
t(lambda: rclpy.create_node("n"))
t(lambda: rclpy.spin_once(None))
t(lambda: rclpy.ok())
from rclpy.executors import *

t(lambda: SingleThreadedExecutor())
t(lambda: rclpy.get_global_executor())
from rclpy.clock import *

t(lambda: Clock().now().nanoseconds > 0)
t(lambda: Clock().sleep_for(Duration(seconds=0.1)))
from rclpy.timer import Timer

t(lambda: Timer(None, None, 5, Clock()))
from rclpy.guard_condition import GuardCondition

t(lambda: GuardCondition(None, None))
t(lambda: rclpy.init(args=5))
t(lambda: rclpy.init(["x"]))
t(lambda: rclpy.shutdown(5))
t(lambda: rclpy.init(args=None, domain_id="x"))
