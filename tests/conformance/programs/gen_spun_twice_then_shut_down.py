"""A thread spins a node, the main program spins it once as well; at shutdown the thread has to come to its end."""
import threading
import time

import rclpy
from rclpy.node import Node

rclpy.init()
node = Node('robot')


def spin():
    try:
        rclpy.spin(node)
    except BaseException as error:
        print('thread:', type(error).__name__)


thread = threading.Thread(target=spin, daemon=True)
thread.start()
time.sleep(0.3)
rclpy.spin_once(node, timeout_sec=0.1)
rclpy.shutdown()
thread.join(5.0)
print('still spinning:', thread.is_alive())
