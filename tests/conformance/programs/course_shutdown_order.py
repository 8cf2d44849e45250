"""What still works after shutdown, and what does not."""

import rclpy
from std_msgs.msg import Empty
from std_srvs.srv import Trigger

rclpy.init()
node = rclpy.create_node("ending")
publisher = node.create_publisher(Empty, "t", 1)
client = node.create_client(Trigger, "s")
clock = node.get_clock()
rclpy.get_default_context().on_shutdown(lambda: print("shutting down"))
rclpy.shutdown()
for name, action in (
    ("ok", rclpy.ok),
    ("publish", lambda: publisher.publish(Empty())),
    ("topic_name", lambda: publisher.topic_name),
    ("call_async", lambda: client.call_async(Trigger.Request())),
    ("get_name", node.get_name),
    ("logger", lambda: node.get_logger().info("still here")),
    ("clock", lambda: clock.now().nanoseconds > 0),
    ("create_publisher", lambda: node.create_publisher(Empty, "x", 1)),
    ("create_node", lambda: rclpy.create_node("again")),
    ("shutdown", rclpy.shutdown),
    ("try_shutdown", rclpy.try_shutdown),
    ("init", lambda: rclpy.init() and "again"),
    ("ok", rclpy.ok),
):
    try:
        print(name, action())
    except Exception as error:
        print(name, type(error).__name__, str(error).splitlines()[0])
rclpy.try_shutdown()
