"""Declares, reads, sets and judges parameters."""

from typing import Any

from rcl_interfaces.msg import FloatingPointRange, ParameterDescriptor, SetParametersResult
from typing_extensions import assert_type

import rclpy
from rclpy.node import Node
from rclpy.parameter import Parameter


class MinimalParam(Node):
    def __init__(self) -> None:
        super().__init__("minimal_param_node")
        limits = ParameterDescriptor(floating_point_range=[FloatingPointRange(from_value=0.0, to_value=2.0)])
        self.declare_parameter("my_parameter", "world")
        speed = self.declare_parameter("speed", 0.5, limits)
        assert_type(speed, Parameter[float])
        assert_type(speed.value, float)
        assert_type(self.declare_parameter("laps", 3).value, int)
        self.declare_parameter("later", Parameter.Type.DOUBLE)
        self.declare_parameters("wheel", [("radius", 0.1), ("names", ["left", "right"])])
        self.add_on_set_parameters_callback(self.judge)
        self.timer = self.create_timer(1, self.timer_callback)

    def judge(self, parameters: list[Parameter[Any]]) -> SetParametersResult:
        return SetParametersResult(successful=all(each.name != "frozen" for each in parameters))

    def timer_callback(self) -> None:
        my_param = self.get_parameter("my_parameter").get_parameter_value().string_value
        assert_type(my_param, str)
        fallback = self.get_parameter_or("absent", Parameter("absent", value=1.5))
        assert_type(fallback, Parameter[float])
        self.get_logger().info(f"Hello {my_param}!")
        new = Parameter("my_parameter", Parameter.Type.STRING, "world")
        assert_type(new, Parameter[str])
        (result,) = self.set_parameters([new])
        assert_type(result, SetParametersResult)


def main() -> None:
    rclpy.init()
    rclpy.spin(MinimalParam())
