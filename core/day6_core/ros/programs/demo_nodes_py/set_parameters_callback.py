"""set_parameters_callback: what a node can do before, while and after a parameter is set."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from rcl_interfaces.msg import SetParametersResult

from day6_core.ros.programs._waiting import spin
from rclpy.parameter import Parameter

if TYPE_CHECKING:
    from day6_core.session.session import Session


async def main(session: Session) -> int:
    node = session.create_node("set_parameters_callback")
    for name in ("param1", "param2"):
        node.declare_parameter(name, 0.0)

    def before(parameters: list[Parameter[Any]]) -> list[Parameter[Any]]:
        more: list[Parameter[Any]] = [
            Parameter("param2", Parameter.Type.DOUBLE, 4.0) for each in parameters if each.name == "param1"
        ]
        return [*parameters, *more]

    def judge(parameters: list[Parameter[Any]]) -> SetParametersResult:
        known = [each.name for each in parameters if each.name in ("param1", "param2")]
        reason = f"success {known[-1]}" if known else ""
        return SetParametersResult(successful=bool(known), reason=reason)

    node.add_pre_set_parameters_callback(before)
    node.add_on_set_parameters_callback(judge)
    return await spin(session, node)
