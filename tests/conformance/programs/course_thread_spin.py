"""Spinning in a thread while the main program publishes and waits."""

import threading

import rclpy
from rclpy.executors import ExternalShutdownException
from std_msgs.msg import Int32

rclpy.init()
node = rclpy.create_node("threaded")
total = 0
enough = threading.Event()


def add(msg):
    global total
    total += msg.data
    if total >= 55:
        enough.set()


node.create_subscription(Int32, "numbers", add, 100)
publisher = node.create_publisher(Int32, "numbers", 100)


def spin():
    try:
        rclpy.spin(node)
    except ExternalShutdownException:
        print("spin ended by shutdown")


thread = threading.Thread(target=spin)
thread.start()
for number in range(1, 11):
    publisher.publish(Int32(data=number))
print(enough.wait(5.0), total)
rclpy.shutdown()
thread.join(5.0)
print(thread.is_alive())
