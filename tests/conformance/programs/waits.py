import rclpy, time, threading
from rclpy.node import Node
from std_msgs.msg import String, Int32
from std_srvs.srv import SetBool, Trigger


def t(f):
    try:
        print("OK", repr(f()))
    except BaseException as e:
        print(type(e).__module__ + "." + type(e).__qualname__, "|", e)


from rclpy.wait_for_message import wait_for_message

rclpy.init()
n = Node("n")
p = n.create_publisher(String, "c", 10)
t(lambda: wait_for_message(String, n, "c", time_to_wait=0.2))
threading.Timer(0.3, lambda: p.publish(String(data="hey"))).start()
t(lambda: wait_for_message(String, n, "c", time_to_wait=3))
t(lambda: n.wait_for_node("n", 1))
t(lambda: n.wait_for_node("/zz", 0.2))
t(lambda: len(list(n.subscriptions)))
from rclpy.duration import Duration

t0 = time.time()
t(lambda: n.get_clock().sleep_for(Duration(seconds=0.2)))
print(round(time.time() - t0, 1))
from rclpy.clock import *

t(lambda: Clock(clock_type=ClockType.STEADY_TIME).sleep_until(n.get_clock().now()))
threading.Timer(0.3, rclpy.shutdown).start()
t(lambda: n.get_clock().sleep_for(Duration(seconds=5)))
