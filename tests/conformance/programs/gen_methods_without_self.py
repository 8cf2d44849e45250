"""The slips with callbacks that a class invites: no self, called instead of named."""
import rclpy
from rclpy.node import Node
from std_msgs.msg import String


class Robot(Node):

    def tick():
        print('tick')

    def hear():
        print('hear')

    def look(self):
        print('look')


def attempt(what, function):
    try:
        function()
        print(what, 'went well')
    except Exception as error:
        print(what, type(error).__name__, error)


rclpy.init()
robot = Robot('robot')
robot.create_timer(0.01, robot.tick)
attempt('a timer without self:', lambda: rclpy.spin_once(robot, timeout_sec=2.0))
attempt('a subscription without self:', lambda: robot.create_subscription(String, 'news', robot.hear, 1))
robot.destroy_node()
other = Robot('other')
other.create_timer(0.01, other.look())
attempt('a timer with what a call gave:', lambda: rclpy.spin_once(other, timeout_sec=2.0))
attempt('a logger for a number:', lambda: other.get_logger().get_child(5))
rclpy.shutdown()
