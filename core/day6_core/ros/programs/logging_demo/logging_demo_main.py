"""logging_demo_main: a node that logs in many ways, and one that changes levels, in one program."""

from __future__ import annotations

from typing import TYPE_CHECKING

from day6_core.ros.programs._component import spin_cpp
from day6_core.ros.programs.logging_demo._components import LoggerConfig, LoggerUsage
from day6_core.ros.programs.rclcpp import create_node

if TYPE_CHECKING:
    from day6_core.ros.programs._component import Component
    from day6_core.session.session import Session


async def main(session: Session) -> int:
    kinds: tuple[type[Component], ...] = (LoggerConfig, LoggerUsage)
    nodes = [create_node(session, kind.NAME, **kind.OPTIONS) for kind in kinds]
    components = [kind(node) for kind, node in zip(kinds, nodes, strict=True)]
    status = await spin_cpp(session, *nodes)
    del components
    return status
