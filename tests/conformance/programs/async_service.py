import rclpy, time, threading
from rclpy.node import Node
from std_msgs.msg import String, Int32
from std_srvs.srv import SetBool, Trigger


def t(f):
    try:
        print("OK", repr(f()))
    except BaseException as e:
        print(type(e).__module__ + "." + type(e).__qualname__, "|", e)


from rclpy.callback_groups import ReentrantCallbackGroup

rclpy.init()
n = Node("n")
g = ReentrantCallbackGroup()


def srv(q, r):
    r.message = "yes"
    print("served")
    return r


s = n.create_service(SetBool, "sb", srv, callback_group=g)
c = n.create_client(SetBool, "sb", callback_group=g)
c.wait_for_service()


async def cb():
    tm.cancel()
    print("before")
    res = await c.call_async(SetBool.Request(data=True))
    print("after", res)


tm = n.create_timer(0.1, cb)


async def srv2(q, r):
    res = await c.call_async(SetBool.Request())
    r.message = "outer " + res.message
    return r


s2 = n.create_service(Trigger, "tr", srv2, callback_group=g)
c2 = n.create_client(Trigger, "tr")
c2.wait_for_service()
for i in range(10):
    rclpy.spin_once(n, timeout_sec=0.05)
f = c2.call_async(Trigger.Request())
f.add_done_callback(lambda x: print("done cb", x.result()))
rclpy.spin_until_future_complete(n, f, timeout_sec=2)
print(f.result())
for i in range(3):
    rclpy.spin_once(n, timeout_sec=0.05)
print(f.done(), f.cancelled(), f.exception())
rclpy.shutdown()
