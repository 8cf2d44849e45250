"""What beginners get wrong most often, and the import paths and old spellings people use."""
import importlib
import warnings

import rclpy
from rclpy.node import Node
from std_msgs.msg import Float64, Int32, String
from std_srvs.srv import SetBool


def attempt(name, action):
    with warnings.catch_warnings(record=True) as caught:
        warnings.simplefilter("always")
        try:
            print(name, "->", action())
        except Exception as error:
            print(name, "->", type(error).__name__, str(error).splitlines()[0] if str(error) else "")
    for warning in caught:
        # A RuntimeWarning is about real rclpy's own clean-up.
        if warning.category is not RuntimeWarning:
            print("   ", warning.category.__name__, warning.message)


class Early(Node):
    def __init__(self):
        self.publisher = self.create_publisher(String, "early", 10)
        super().__init__("early")


attempt("node before init", lambda: rclpy.create_node("n"))
rclpy.init()
attempt("init twice", rclpy.init)
node = Node("n")
attempt("publisher before super", Early)
attempt("positional message", lambda: String("x"))
attempt("keyword message", lambda: String(data="x"))
attempt("log a number", lambda: node.get_logger().info(5))
attempt("log a message", lambda: node.get_logger().info(String()))
attempt("log two", lambda: node.get_logger().info("a", "b"))
attempt("no qos", lambda: node.create_publisher(String, "x"))
attempt("publish a number", lambda: node.create_publisher(String, "x", 10).publish(5))
attempt("publish another type", lambda: node.create_publisher(String, "x", 10).publish(Int32()))
attempt("topic is no type", lambda: node.create_publisher("x", String, 10))
attempt("service as message", lambda: node.create_subscription(SetBool, "x", print, 10))
attempt("message as service", lambda: node.create_service(String, "x", print))
attempt("negative depth", lambda: node.create_publisher(String, "x", -1))
attempt("text as qos", lambda: node.create_publisher(String, "x", "10"))
attempt("other type of topic", lambda: node.create_subscription(Float64, "x", print, 10) and None)
attempt("callback with no argument", lambda: node.create_subscription(String, "y", lambda: None, 10))
attempt("no callback", lambda: node.create_subscription(String, "y", None, 10))
attempt("timer with text", lambda: node.create_timer("1", print) and "made")
attempt("timer without time", lambda: node.create_timer(None, print))
attempt("negative timer", lambda: node.create_timer(-1.0, print))
attempt("declare without default", lambda: node.declare_parameter("p").value)
attempt("declare twice", lambda: node.declare_parameter("p", 1))
attempt("undeclared", lambda: node.get_parameter("q").value)
attempt("typed, no value", lambda: node.declare_parameter("typed", rclpy.Parameter.Type.INTEGER).value)
attempt("read it", lambda: node.get_parameter("typed").value)
attempt("number", lambda: node.declare_parameter("number", 1).value)
attempt("other type", lambda: node.set_parameters([rclpy.Parameter("number", value="one")])[0].reason)
attempt("bad node name", lambda: Node("bad name"))
attempt("bad topic", lambda: node.create_publisher(String, "bad topic", 10))
attempt("destroy twice", lambda: (node.destroy_node(), node.destroy_node()))
attempt("destroyed", lambda: node.create_publisher(String, "x", 10))
for path in (
    "rclpy.Parameter rclpy.parameter.Parameter rclpy.time.Duration rclpy.duration.Duration rclpy.parameter.ParameterType "
    "rclpy.parameter.ParameterValue rclpy.action.server.ServerGoalHandle rclpy.action.client.GoalStatus "
    "rclpy.executors.ExternalShutdownException rclpy.qos.qos_profile_default rclpy.qos.qos_profile_sensor_data "
    "rclpy.qos.QoSReliabilityPolicy rclpy.qos.QoSDurabilityPolicy rclpy.qos.ReliabilityPolicy rclpy.node.ReentrantCallbackGroup "
    "rclpy.qos.QoSPresetProfiles rclpy.executors.ShutdownException rclpy.task.Future rclpy.time.Time rclpy.clock.ClockType"
).split():
    module, _, name = path.rpartition(".")
    value = getattr(importlib.import_module(module), name)
    print(path, value.__name__ if isinstance(value, type) else type(value).__name__)
attempt("old choice", lambda: rclpy.qos.QoSReliabilityPolicy.RMW_QOS_POLICY_RELIABILITY_BEST_EFFORT)
attempt("shutdown", rclpy.shutdown)
attempt("shutdown twice", rclpy.shutdown)
attempt("after the end", lambda: rclpy.create_node("late"))
