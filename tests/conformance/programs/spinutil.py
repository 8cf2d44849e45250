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


from rclpy.task import Future

rclpy.init()
n = Node("n")
f = Future()
threading.Timer(0.2, lambda: f.set_result(1)).start()
t0 = time.time()
rclpy.spin_until_future_complete(n, f)
print(0.1 < time.time() - t0 < 1.5, f.result())
f = Future()
f.set_result(2)
rclpy.spin_until_future_complete(n, f)
print("at once")
f = Future()
f.cancel()
rclpy.spin_until_future_complete(n, f, timeout_sec=1)
print("cancelled")
f = Future()
t0 = time.time()
rclpy.spin_until_future_complete(n, f, timeout_sec=0)
print(time.time() - t0 < 0.3)
f = Future()
n.create_timer(0.05, lambda: f.set_exception(ValueError("x")) if not f.done() else None)
t(lambda: rclpy.spin_until_future_complete(n, f, timeout_sec=1))
t(lambda: f.result())
ex = rclpy.get_global_executor()
t(lambda: ex.spin_until_future_complete(Future(), timeout_sec=0.1))
t(lambda: ex.spin_once_until_future_complete(Future(), 0.1))
rclpy.shutdown()
