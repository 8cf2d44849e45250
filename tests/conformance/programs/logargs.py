import rclpy, time, threading
from rclpy.node import Node
from std_msgs.msg import String, Int32
from std_srvs.srv import SetBool, Trigger


def t(f):
    try:
        print("OK", repr(f()))
    except BaseException as e:
        print(type(e).__module__ + "." + type(e).__qualname__, "|", e)


import os

os.environ["RCUTILS_LOGGING_USE_STDOUT"] = "1"
os.environ["RCUTILS_COLORIZED_OUTPUT"] = "1"
rclpy.init(args=["--ros-args", "--log-level", "m:=debug", "--log-level", "n:=error"])
n = Node("n")
m = Node("m")
for L in (n.get_logger(), m.get_logger(), m.get_logger().get_child("x")):
    L.debug("d")
    L.info("i")
    L.warning("w")
    L.error("e")
    L.fatal("f")
rclpy.shutdown()
