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

os.environ["RCUTILS_CONSOLE_OUTPUT_FORMAT"] = (
    "{severity}|{name}|{message}|{function_name}|{file_name}|{line_number}|{unknown}|{|}|\\n\\t|{short_file_name}|{severity"
)
rclpy.init()
Node("n").get_logger().info("hi")


def foo():
    Node("m").get_logger().error("{name} in message")


foo()
rclpy.shutdown()
