"""parameter_blackboard: a node that accepts any parameters."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from day6_core.ros.programs._component import run

if TYPE_CHECKING:
    from day6_core.session.session import Session
    from rclpy.node import Node


class ParameterBlackboard:
    """Undeclared parameters can be set."""

    NAME = "parameter_blackboard"
    OPTIONS: dict[str, Any] = {
        "allow_undeclared_parameters": True,
        "automatically_declare_parameters_from_overrides": True,
    }

    def __init__(self, node: Node) -> None:
        number = len(node._parameters)
        node.get_logger().info(
            f"Parameter blackboard node named '{node.get_fully_qualified_name()}' ready, and serving '{number}' "
            "parameters already!"
        )


async def main(session: Session) -> int:
    return await run(session, ParameterBlackboard)
