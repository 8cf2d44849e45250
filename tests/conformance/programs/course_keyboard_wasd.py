"""Keys read line by line become velocities; the input comes from course_keyboard_wasd.input."""

import sys

import rclpy
from geometry_msgs.msg import Twist

KEYS = {"w": (1.0, 0.0), "s": (-1.0, 0.0), "a": (0.0, 1.0), "d": (0.0, -1.0)}
rclpy.init()
node = rclpy.create_node("wasd")
publisher = node.create_publisher(Twist, "cmd_vel", 10)
node.create_subscription(Twist, "cmd_vel", lambda t: print("moves", t.linear.x, t.angular.z), 10)
print("terminal:", sys.stdin.isatty())
while True:
    try:
        key = input("key> ").strip()
    except EOFError:
        print("end of input")
        break
    if key == "q":
        print("bye")
        break
    if key not in KEYS:
        print("unknown key", repr(key))
        continue
    twist = Twist()
    twist.linear.x, twist.angular.z = KEYS[key]
    publisher.publish(twist)
    rclpy.spin_once(node, timeout_sec=0.5)
node.destroy_node()
rclpy.shutdown()
