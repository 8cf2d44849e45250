import rclpy, time, threading
from rclpy.node import Node
from std_msgs.msg import String, Int32
from std_srvs.srv import SetBool, Trigger


def t(f):
    try:
        print("OK", repr(f()))
    except BaseException as e:
        print(type(e).__module__ + "." + type(e).__qualname__, "|", e)


import asyncio

rclpy.init()
n = Node("n")
s = n.create_service(Trigger, "x", lambda a, b: b)
c = n.create_client(Trigger, "x")
c.wait_for_service()


async def spin():
    while rclpy.ok():
        rclpy.spin_once(n, timeout_sec=0)
        await asyncio.sleep(0.001)


async def main():
    sp = asyncio.create_task(spin())
    r = await c.call_async(Trigger.Request())
    print(r)
    sp.cancel()


asyncio.run(main())
rclpy.shutdown()
