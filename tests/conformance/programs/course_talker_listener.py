"""A talker and a listener in one program, stopped after five messages."""

import rclpy
from rclpy.node import Node
from std_msgs.msg import String


class Talker(Node):
    def __init__(self):
        super().__init__("talker")
        self.publisher = self.create_publisher(String, "chatter", 10)
        self.timer = self.create_timer(0.05, self.tick)
        self.count = 0

    def tick(self):
        msg = String()
        msg.data = f"Hello {self.count}"
        self.publisher.publish(msg)
        self.get_logger().info(f'Publishing: "{msg.data}"')
        self.count += 1


class Listener(Node):
    def __init__(self):
        super().__init__("listener")
        self.heard = []
        self.create_subscription(String, "chatter", self.on_message, 10)

    def on_message(self, msg):
        self.heard.append(msg.data)
        self.get_logger().info(f'I heard: "{msg.data}"')


rclpy.init()
talker, listener = Talker(), Listener()
executor = rclpy.executors.SingleThreadedExecutor()
executor.add_node(listener)
executor.add_node(talker)
while len(listener.heard) < 5:
    executor.spin_once(timeout_sec=1.0)
print(listener.heard)
print(talker.get_name(), listener.get_name(), sorted(n.get_name() for n in executor.get_nodes()))
rclpy.shutdown()
print(rclpy.ok())
