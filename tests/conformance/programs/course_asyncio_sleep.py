"""asyncio beside rclpy: a task polls spin_once."""

import asyncio

import rclpy
from std_msgs.msg import String


async def spin(node):
    while rclpy.ok():
        rclpy.spin_once(node, timeout_sec=0)
        await asyncio.sleep(0.005)


async def main():
    rclpy.init()
    node = rclpy.create_node("aio")
    got = asyncio.get_running_loop().create_future()
    node.create_subscription(String, "news", lambda m: got.done() or got.set_result(m.data), 10)
    publisher = node.create_publisher(String, "news", 10)
    task = asyncio.create_task(spin(node))
    while publisher.get_subscription_count() == 0:
        await asyncio.sleep(0.01)
    publisher.publish(String(data="from asyncio"))
    print(await asyncio.wait_for(got, 5))
    rclpy.shutdown()
    await task


asyncio.run(main())
print("done")
