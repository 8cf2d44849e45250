import rclpy, time, threading
from rclpy.node import Node
from std_msgs.msg import String, Int32
from std_srvs.srv import SetBool, Trigger


def t(f):
    try:
        print("OK", repr(f()))
    except BaseException as e:
        print(type(e).__module__ + "." + type(e).__qualname__, "|", e)


from rcl_interfaces.msg import Log
from rclpy.qos import *

rclpy.init()
n = Node("n")
m = Node("m")
n.get_logger().info("early")
got = []
s = m.create_subscription(
    Log,
    "/rosout",
    lambda x: got.append((x.level, x.name, x.msg, x.function, x.line, x.file[-3:])),
    qos_profile_rosout_default,
)


def fn():
    n.get_logger().warning("inside")
    n.get_logger().get_child("kid").error("from kid")


time.sleep(0.3)
fn()
rclpy.logging.get_logger("stranger").info("not there")
n.get_logger().debug("no")
for i in range(10):
    rclpy.spin_once(m, timeout_sec=0.1)
print(got)
rclpy.shutdown()
