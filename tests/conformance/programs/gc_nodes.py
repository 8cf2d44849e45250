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


import gc

rclpy.init()
n = Node("keep")


def f():
    x = Node("temp")
    x.create_publisher(String, "t", 1)
    return x.get_name()


print(f())
gc.collect()
time.sleep(0.4)
print(n.get_node_names())
y = Node("temp2")
del y
gc.collect()
time.sleep(0.4)
print(n.get_node_names(), n.get_topic_names_and_types()[0][0])
with Node("cm") as z:
    print(z.get_name())
t(lambda: z.get_name())
rclpy.shutdown()
