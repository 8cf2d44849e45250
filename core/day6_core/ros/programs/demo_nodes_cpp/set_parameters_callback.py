"""set_parameters_callback: what a node can do before, while and after a parameter is set."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from rcl_interfaces.msg import SetParametersResult

from day6_core.ros.programs._component import run
from rclpy.parameter import Parameter

MEMBERS = {"param1": "value_1_", "param2": "value_2_"}
EXPLANATION = """\
This node demonstrates the use of parameter callbacks.
As an example, it exhibits the following behavior:
 * Two parameters of type double are declared in the node: 'param1' and 'param2'
 * 'param1' cannot be set to a value > 5.0
 * 'param2' cannot be set to a value < -5.0
 * Each time 'param1' is set, 'param2' is automatically set to 4.0
 * Member variables 'value_1_' and 'value_2_' are updated upon change of the parameters.
To try it out set a parameter, e.g.:
  ros2 param set set_param_callback_node param1 10.0
  ros2 param set set_param_callback_node param1 3.0
The first command will fail.
The 2nd command will set 'param1' to 3.0 and 'param2' to 4.0."""


if TYPE_CHECKING:
    from day6_core.session.session import Session
    from rclpy.node import Node


class SetParametersCallback:
    """`param1` at most 5.0, `param2` at least -5.0; who sets the one sets the other to 4.0."""

    NAME = "set_param_callback_node"
    OPTIONS: dict[str, Any] = {}

    def __init__(self, node: Node) -> None:
        self._info = node.get_logger().info
        for name, value in (("param1", 1.0), ("param2", 2.0)):
            node.declare_parameter(name, value)
        node.add_pre_set_parameters_callback(self._before)
        node.add_on_set_parameters_callback(self._judge)
        node.add_post_set_parameters_callback(self._after)
        for line in EXPLANATION.splitlines():
            self._info(line)

    def _before(self, parameters: list[Parameter[Any]]) -> list[Parameter[Any]]:
        more: list[Parameter[Any]] = [
            Parameter("param2", Parameter.Type.DOUBLE, 4.0) for each in parameters if each.name == "param1"
        ]
        return [*parameters, *more]

    def _judge(self, parameters: list[Parameter[Any]]) -> SetParametersResult:
        for each in parameters:
            if each.name == "param1" and each.value > 5.0:
                return SetParametersResult(successful=False, reason="cannot set 'param1' > 5.0")
            if each.name == "param2" and each.value < -5.0:
                return SetParametersResult(successful=False, reason="cannot set 'param2' < -5.0")
        return SetParametersResult(successful=True)

    def _after(self, parameters: list[Parameter[Any]]) -> None:
        for each in parameters:
            if each.name in MEMBERS:
                self._info(f"Member variable '{MEMBERS[each.name]}' set to: {each.value:f}.")


async def main(session: Session) -> int:
    return await run(session, SetParametersCallback)
