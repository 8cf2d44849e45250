"""Ctrl-C in every call that blocks: where the traceback says the program was."""

import os
import signal
import threading
import traceback
from pathlib import Path

from std_msgs.msg import String
from std_srvs.srv import Trigger

import rclpy
from rclpy.duration import Duration
from rclpy.wait_for_message import wait_for_message


def ctrl_c_while(name, wait):
    rclpy.init()
    node = rclpy.create_node(name)
    ctrl_c = threading.Timer(0.4, os.kill, (os.getpid(), signal.SIGINT))
    ctrl_c.start()
    try:
        print(name, "returned", wait(node))
    except BaseException as error:
        frames = [Path(frame.filename) for frame in traceback.extract_tb(error.__traceback__)]
        print(name, type(error).__name__, [path.name for path in frames if "rclpy" not in path.parts])
    ctrl_c.join()
    rclpy.try_shutdown()


ctrl_c_while("wait_for_service", lambda node: node.create_client(Trigger, "nobody").wait_for_service())
ctrl_c_while("with_timeout", lambda node: node.create_client(Trigger, "nobody").wait_for_service(timeout_sec=5.0))
ctrl_c_while("call", lambda node: node.create_client(Trigger, "nobody").call(Trigger.Request()))
ctrl_c_while("sleep_for", lambda node: node.get_clock().sleep_for(Duration(seconds=5)))
ctrl_c_while("wait_for_message", lambda node: wait_for_message(String, node, "nothing", time_to_wait=5))
ctrl_c_while("wait_for_node", lambda node: node.wait_for_node("nobody", 5.0))
ctrl_c_while("rate", lambda node: node.create_rate(0.2).sleep())
ctrl_c_while("spin_once", lambda node: rclpy.spin_once(node, timeout_sec=5.0))
