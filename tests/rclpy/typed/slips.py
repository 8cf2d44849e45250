"""Mistakes that a type checker tells before the program runs; each line marked so has to be an error."""

from example_interfaces.action import Fibonacci
from example_interfaces.srv import AddTwoInts
from geometry_msgs.msg import Twist
from std_msgs.msg import String

from rclpy.action import ActionClient, ActionServer
from rclpy.node import Node
from rclpy.parameter import Parameter


def on_twist(message: Twist) -> None:
    print(message.linear.x)


def serve(request: AddTwoInts.Request, response: AddTwoInts.Response) -> AddTwoInts.Request:
    response.sum = request.a
    return request


def slips(node: Node) -> None:
    publisher = node.create_publisher(String, "c", 10)
    publisher.publish(Twist())  # error: another type
    publisher.publish("text")  # error: no message
    node.create_subscription(String, "c", on_twist, 10)  # error: the callback wants another type
    node.create_subscription(String, "c", lambda message: print(message.dat), 10)  # error: no such field
    node.create_publisher(AddTwoInts, "c", 10)  # error: a service
    node.create_publisher(String, "c")  # error: no QoS
    Twist().linear = 0.5  # error: a Vector3
    Twist().linear.w = 0.5  # error: no such field
    String(data=5)  # error: a number
    node.create_service(AddTwoInts, "s", serve)  # error: returns the request
    client = node.create_client(AddTwoInts, "s")
    client.call_async(AddTwoInts.Response())  # error: the response
    client.call_async(AddTwoInts.Request(c=1))  # error: no such field
    print(client.call_async(AddTwoInts.Request()).result().sum)  # error: perhaps None
    node.create_client(String, "s")  # error: a message
    node.create_timer("1", slips)  # error: a text
    action_client = ActionClient(node, Fibonacci, "f")
    action_client.send_goal_async(Fibonacci.Result())  # error: the result
    ActionServer(node, Fibonacci, "f", lambda goal_handle: Fibonacci.Goal())  # error: returns a goal
    ActionServer(node, Fibonacci, "f", lambda goal_handle: goal_handle.request.sequence)  # error: a goal has none
    node.set_parameters([("speed", 1)])  # error: no parameters
    node.declare_parameter("speed", 0.5).value.upper()  # error: a float
    Parameter("speed", value={"a": 1})  # error: no parameter has such a value
    node.get_logger().info("x", throttle_seconds=1)  # error: no such argument
    node.get_logger().info(5)  # error: no text
