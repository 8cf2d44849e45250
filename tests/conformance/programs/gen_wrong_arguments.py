"""Arguments of wrong types, and what is used after its end; which exception was being handled is shown too."""
import rclpy
from rclpy.action import ActionClient
from rclpy.node import Node
from rclpy.parameter import Parameter
from rclpy.serialization import deserialize_message, serialize_message
from std_msgs.msg import String
from test_msgs.action import Fibonacci


def attempt(function):
    try:
        print('went well:', function())
    except Exception as error:
        context = None if error.__suppress_context__ else error.__context__
        print(type(error).__name__, error, '|', repr(context))


rclpy.init()
node = Node('robot')
publisher = node.create_publisher(String, 'news', 1)
for name in ('my news', '', 'a//b', '{robot}', '~news'):
    attempt(lambda: node.create_publisher(String, name, 1))
    attempt(lambda: node.create_subscription(String, name, print, 1))
for name, namespace in (('', '/'), ('a b', '/'), ('4wd', '/'), ('r' * 300, '/'), ('robot', 'lab'), ('robot', '/lab/')):
    attempt(lambda: node.get_service_names_and_types_by_node(name, namespace))
attempt(lambda: len(node.get_publisher_names_and_types_by_node('robot', '')))
attempt(lambda: node.get_publishers_info_by_topic(5))
attempt(lambda: publisher.wait_for_all_acked(1.0))
attempt(lambda: rclpy.logging.get_logging_severity_from_string(5))
attempt(lambda: deserialize_message('text', String))
attempt(lambda: deserialize_message(bytearray(8), String))
attempt(lambda: serialize_message(String))
attempt(lambda: node.declare_parameter('count', 2**63))
attempt(lambda: node.has_parameter('count'))
node.declare_parameter('size', 1)
attempt(lambda: node.set_parameters([Parameter('size', value=-2**63 - 1)]))
attempt(lambda: node.get_parameter('size').value)
client = ActionClient(node, Fibonacci, 'fibonacci')
client.destroy()
attempt(lambda: client.send_goal_async(Fibonacci.Goal(order=1)))
attempt(client.server_is_ready)
rclpy.shutdown()
attempt(lambda: node.create_publisher(String, 'news', 1))
