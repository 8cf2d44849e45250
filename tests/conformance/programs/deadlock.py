import rclpy, time, threading
from rclpy.node import Node
from std_msgs.msg import String, Int32
from std_srvs.srv import SetBool, Trigger


def t(f):
    try:
        print("OK", repr(f()))
    except BaseException as e:
        print(type(e).__module__ + "." + type(e).__qualname__, "|", e)


rclpy.init()
n = Node("n")
s = n.create_service(SetBool, "sb", lambda q, r: r)
c = n.create_client(SetBool, "sb")
c.wait_for_service()


def cb():
    tm.cancel()
    f = c.call_async(SetBool.Request())
    rclpy.spin_until_future_complete(n, f, timeout_sec=0.5)
    print("inside done", f.done())
    t(lambda: c.call(SetBool.Request(), timeout_sec=0.3))
    rclpy.spin_once(n, timeout_sec=0.1)
    print("spun")


tm = n.create_timer(0.1, cb)
rclpy.spin_once(n)
for i in range(6):
    rclpy.spin_once(n, timeout_sec=0.1)
print("end")
rclpy.shutdown()
