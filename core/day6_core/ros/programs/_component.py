"""Nodes as rclcpp's components: a class that is given its node, run by its own executable or loaded into a container."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any, Protocol

from day6_core.ros.programs.rclcpp import STOPPED, create_node, log_interrupt

if TYPE_CHECKING:
    from day6_core.session.session import Session
    from rclpy.node import Node


class Component(Protocol):
    """Base of components. `NAME` is the node's name unless it is remapped, `OPTIONS` holds more keywords of `Node`."""

    NAME: str
    OPTIONS: dict[str, Any]

    def __init__(self, node: Node) -> None: ...


async def run(session: Session, kind: type[Component]) -> int:
    """Run as the executable of one component: spin until Ctrl-C, or until the component shuts its context down."""
    node = create_node(session, kind.NAME, **kind.OPTIONS)
    component = kind(node)
    status = await spin_cpp(session, node)
    del component  # it lives as long as its node spins
    return status


async def spin_cpp(session: Session, *nodes: Node) -> int:
    """Spin as a C++ program does, which logs at Ctrl-C that it was interrupted."""
    try:
        await session.spin(*nodes)
    except STOPPED:
        log_interrupt(session)
    return 0


async def ready(session: Session, look: Any, seconds: float) -> bool:
    """Wait until `look()` is true, for at most this many seconds of world time; return whether it is."""
    deadline = session.clock.steady_ns() + int(seconds * 1e9)
    while not look():
        if session.clock.steady_ns() >= deadline:
            return False
        await session.sleep(0.02)
    return True
