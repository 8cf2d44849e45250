"""Runs four components in one process, as the executables of this package do."""

from __future__ import annotations

from typing import TYPE_CHECKING

from day6_core.ros.programs._component import spin_cpp
from day6_core.ros.programs.composition._components import Client, Server, Talker
from day6_core.ros.programs.demo_nodes_cpp.listener import Listener
from day6_core.ros.programs.rclcpp import create_node

if TYPE_CHECKING:
    from day6_core.ros.programs._component import Component
    from day6_core.session.session import Session


async def run_together(session: Session) -> int:
    """Spin a talker, a listener, a server and a client until Ctrl-C."""
    kinds: tuple[type[Component], ...] = (Talker, Listener, Server, Client)
    nodes = [create_node(session, kind.NAME, **kind.OPTIONS) for kind in kinds]
    components = [kind(node) for kind, node in zip(kinds, nodes, strict=True)]
    status = await spin_cpp(session, *nodes)
    del components
    return status
