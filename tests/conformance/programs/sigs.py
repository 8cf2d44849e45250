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


import signal, os
from rclpy.signals import *

print(signal.getsignal(signal.SIGTERM))
hits = []
signal.signal(signal.SIGINT, lambda s, f: hits.append("own"))
rclpy.init()
n = Node("n")
print(get_current_signal_handlers_options())
os.kill(os.getpid(), signal.SIGINT)
time.sleep(0.3)
print(hits, rclpy.ok())
rclpy.try_shutdown()
print(get_current_signal_handlers_options())
rclpy.init(signal_handler_options=SignalHandlerOptions.SIGTERM)
n = Node("n")
os.kill(os.getpid(), signal.SIGINT)
time.sleep(0.2)
print(hits, rclpy.ok())
os.kill(os.getpid(), signal.SIGTERM)
time.sleep(0.3)
print(rclpy.ok())
uninstall_signal_handlers()
print(get_current_signal_handlers_options())
