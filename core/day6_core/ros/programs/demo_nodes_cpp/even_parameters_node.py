"""even_parameters_node: a node whose parameters can only be even integers."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from rcl_interfaces.msg import SetParametersResult

from day6_core.ros.programs._component import run
from rclpy.parameter import Parameter

if TYPE_CHECKING:
    from day6_core.session.session import Session
    from rclpy.node import Node


class EvenParameterNode:
    """Refuses everything else, with a reason."""

    NAME = "even_parameters_node"
    OPTIONS: dict[str, Any] = {"allow_undeclared_parameters": True}

    def __init__(self, node: Node) -> None:
        self._info = node.get_logger().info
        self._info("This example node shows a parameter callback that rejects")
        self._info("all parameter updates except for those that set an even integer.")
        self._info("Try running 'ros2 param set /even_parameters_node myint 2' to")
        self._info("successfully set a parameter.")
        node.add_on_set_parameters_callback(self._judge)

    def _judge(self, parameters: list[Parameter[Any]]) -> SetParametersResult:
        result = SetParametersResult(successful=True)
        for each in parameters:
            if each.type_ == Parameter.Type.NOT_SET:
                self._info(f"parameter '{each.name}' deleted successfully")
            elif each.type_ != Parameter.Type.INTEGER:
                self._info(
                    "only integer parameters can be set\n"
                    f"requested value for parameter '{each.name}' is not an even number, rejecting change..."
                )
                result = SetParametersResult(successful=False, reason="only integer parameters can be set")
            elif each.value % 2:
                self._info(
                    f"Requested value '{each.value}' for parameter '{each.name}' is not an even number: "
                    "rejecting change..."
                )
                result = SetParametersResult(successful=False, reason="only even integers can be set")
            else:
                self._info(f"parameter '{each.name}' has changed and is now: {each.value}")
        return result


async def main(session: Session) -> int:
    return await run(session, EvenParameterNode)
