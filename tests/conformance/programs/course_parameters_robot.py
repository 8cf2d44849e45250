"""Parameters with types, a callback that refuses, and what reading them gives."""

import rclpy
from rcl_interfaces.msg import FloatingPointRange, ParameterDescriptor, SetParametersResult
from rclpy.node import Node
from rclpy.parameter import Parameter


class Robot(Node):
    def __init__(self):
        super().__init__("robot")
        self.declare_parameter(
            "speed",
            0.5,
            ParameterDescriptor(
                description="metres per second", floating_point_range=[FloatingPointRange(from_value=0.0, to_value=2.0)]
            ),
        )
        self.declare_parameter("name", "Robbie")
        self.declare_parameters("wheel", [("radius", 0.1), ("count", 4), ("driven", [True, False])])
        self.add_on_set_parameters_callback(self.check)

    def check(self, params):
        for param in params:
            if param.name == "name" and not param.value:
                return SetParametersResult(successful=False, reason="a robot needs a name")
        return SetParametersResult(successful=True)


rclpy.init()
robot = Robot()
for name in ("speed", "name", "wheel.radius", "wheel.count", "wheel.driven"):
    p = robot.get_parameter(name)
    print(name, p.type_, p.value, p.get_parameter_value().type)
for new in (
    Parameter("speed", value=1.5),
    Parameter("speed", value=3.0),
    Parameter("speed", value="fast"),
    Parameter("name", value=""),
    Parameter("name", value="Ada"),
    Parameter("nope", value=1),
):
    try:
        result = robot.set_parameters([new])
        print(new.name, new.value, result[0].successful, result[0].reason)
    except Exception as error:
        print(type(error).__name__, error)
print(robot.get_parameter("speed").value, robot.get_parameter("name").value)
print(sorted(robot.get_parameters_by_prefix("wheel")))
print(robot.describe_parameter("speed").description, robot.has_parameter("wheel.count"))
print(robot.get_parameter_or("missing", Parameter("missing", value=7)).value)
robot.undeclare_parameter("name")
print(robot.has_parameter("name"))
rclpy.shutdown()
