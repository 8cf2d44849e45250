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


rclpy.init()
n = Node("n")
t(lambda: n.create_timer())
t(lambda: n.create_subscription(String, "c", print))
t(lambda: n.create_subscription())
t(lambda: n.create_service(SetBool, "x"))
t(lambda: n.create_client())
t(lambda: n.create_publisher(topic="x", msg_type=String, qos_profile=1).topic)
t(lambda: n.declare_parameter())
t(lambda: n.get_parameter())
t(lambda: n.foo())
t(lambda: n.get_logger("x"))
t(lambda: n.create_publisher(String, "c", 10, 10))
t(lambda: n.destroy_node(5))
t(lambda: Node("m", foo=1))
t(lambda: n.create_guard_condition())
t(lambda: n.get_namespace())
t(lambda: n.get_clock())
t(lambda: n.wait_for_node())
t(lambda: n.context.ok())
t(lambda: n.executor)
t(lambda: n.add_waitable(5))
t(lambda: rclpy.create_node("k", namespace="/q").get_fully_qualified_name())
t(lambda: rclpy.create_node())
t(lambda: rclpy.spin(n, 5))
t(lambda: rclpy.spin_until_future_complete(n))
t(lambda: rclpy.spin_until_future_complete(n, 5, timeout_sec=0.1))
t(lambda: rclpy.spin_once(n, 0.1))
t(lambda: rclpy.spin_once(n, timeout_sec="x"))
rclpy.shutdown()
