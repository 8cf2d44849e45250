"""The nodes by which `ros2` looks at the graph: the daemon's if there is one, else one of its own, `/_ros2cli_<pid>`."""

from __future__ import annotations

import threading
from collections.abc import AsyncIterator
from contextlib import asynccontextmanager
from typing import TYPE_CHECKING, Any
from weakref import WeakSet

from day6_tui.core.ros.ros2.cli import daemon
from day6_tui.core.session.task import Signal

if TYPE_CHECKING:
    from day6_tui.core.session.session import Session
    from rclpy.node import Node

PREFIX = "_ros2cli"
HIDDEN_PREFIX = "_"


_settled: WeakSet[Any] = WeakSet()


async def settle(session: Session, timeout: float = 1.0) -> None:
    """Wait until the link, if there is one, has told this process's graph what the others have: once for each link.

    `timeout` is in seconds of the wall, because the link lives in it.
    """
    link: Any = getattr(session.graph, "transport", None)
    if not hasattr(link, "wait_settled") or link in _settled:
        return
    known = Signal()

    def look() -> None:
        try:
            if link.wait_settled(timeout):
                _settled.add(link)
        finally:
            known.set()

    threading.Thread(target=look, name="day6-settle", daemon=True).start()
    await session.wait(known)


async def direct_node(session: Session, args: Any = None, name: str | None = None) -> Node:
    """Make this command's own node; ROS arguments of the command line are not for it. Destroyed with the session."""
    from rclpy.parameter import Parameter

    await settle(session)
    node = session.create_node(
        name or f"{PREFIX}_{session.pid}",
        cli_args=[],
        start_parameter_services=False,
        parameter_overrides=[
            Parameter("use_sim_time", value=bool(getattr(args, "use_sim_time", False))),
            Parameter("start_type_description_service", value=True),
        ],
        automatically_declare_parameters_from_overrides=True,
    )
    spin_time = getattr(args, "spin_time", None)
    if spin_time:
        # Our graph is known without waiting; who asks for a time gets it, for what is about to appear.
        await session.sleep(spin_time)
    return node


async def plain_node(session: Session, name: str) -> Node:
    """Make a node with everything a user's node has (what `service call` and `action send_goal` do)."""
    await settle(session)
    return session.create_node(name, cli_args=[])


@asynccontextmanager
async def graph_node(session: Session, args: Any = None) -> AsyncIterator[Node]:
    """Give a node to ask the graph with: the daemon's, or with `--no-daemon` (or where none can be) a passing own one."""
    await settle(session)
    if not getattr(args, "no_daemon", False):
        daemon.start(session)
        running = daemon.node_of(session)
        if running is not None:
            with daemon.answering():
                yield running
            return
    node = await direct_node(session, args)
    try:
        yield node
    finally:
        node.destroy_node()


def is_hidden(name: str) -> bool:
    """Say whether a topic, service or action is hidden: one part of its name begins with an underscore."""
    return any(part.startswith(HIDDEN_PREFIX) for part in name.split("/"))


def topics(node: Node, *, hidden: bool) -> list[tuple[str, list[str]]]:
    """Return `(name, types)` of all topics."""
    return [(name, types) for name, types in node.get_topic_names_and_types() if hidden or not is_hidden(name)]


def services(node: Node, *, hidden: bool) -> list[tuple[str, list[str]]]:
    """Return `(name, types)` of all services."""
    return [(name, types) for name, types in node.get_service_names_and_types() if hidden or not is_hidden(name)]


def node_names(node: Node, *, hidden: bool) -> list[str]:
    """Return the full names of all nodes; a name that two nodes share is there twice."""
    return [
        f"{namespace.rstrip('/')}/{name}"
        for name, namespace in node.get_node_names_and_namespaces()
        if hidden or not name.startswith(HIDDEN_PREFIX)
    ]


def absolute(node_name: str) -> str:
    """Return a node's name with the leading slash that users leave out."""
    return node_name if node_name.startswith("/") else f"/{node_name}"


def split_name(full_name: str) -> tuple[str, str]:
    """Return `(name, namespace)` of a node's full name."""
    namespace, _, name = absolute(full_name).rpartition("/")
    return name, namespace or "/"
