"""The node through which `ros2` queries the graph: the daemon's if there is one, else its own, `/_ros2cli_<pid>`."""

from __future__ import annotations

import threading
from collections.abc import AsyncIterator, Callable
from contextlib import asynccontextmanager, nullcontext
from typing import TYPE_CHECKING, Any
from weakref import WeakSet

from day6_core.graph.names import OBSERVER_PREFIX, is_hidden
from day6_core.ros.ros2.cli import daemon
from day6_core.session.task import Signal

if TYPE_CHECKING:
    from day6_core.graph.graph import Transport
    from day6_core.session.session import Session
    from rclpy.node import Node

PREFIX = "_ros2cli"
HIDDEN_PREFIX = "_"
POLL_SECONDS = 0.05


_settled: WeakSet[Transport] = WeakSet()


async def settle(session: Session, timeout: float = 1.0) -> None:
    """Wait until the link, if there is one, has brought the other processes' entities into the graph; once per link.

    `timeout` is in seconds of wall time, because the link does not follow the world's clock.
    """
    link = session.graph.transport if session.graph is not None else None
    if link is None or link in _settled:
        return
    known = Signal()

    def wait() -> None:
        try:
            if link.wait_settled(timeout):
                _settled.add(link)
        finally:
            known.set()

    threading.Thread(target=wait, name="day6-settle", daemon=True).start()
    await session.wait(known)


async def direct_node(session: Session, args: Any = None, name: str | None = None) -> Node:
    """Create this command's own node, without the command line's ROS arguments. It is destroyed with the session."""
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
        # Our graph is known without waiting; but a given time is waited, for entities that are about to appear.
        await session.sleep(spin_time)
    return node


async def plain_node(session: Session, name: str) -> Node:
    """Create a node with everything a user's node has (for `service call` and `action send_goal`)."""
    await settle(session)
    return session.create_node(name, cli_args=[])


@asynccontextmanager
async def graph_node(session: Session, args: Any = None) -> AsyncIterator[Node]:
    """Yield a node for queries of the graph: the daemon's, or a temporary one (`--no-daemon`, or no daemon possible).

    Where the daemon is another process the temporary one is not to be seen, for the real command then has none.
    """
    await settle(session)
    through_daemon = not getattr(args, "no_daemon", False)
    if through_daemon:
        daemon.start(session)
        running = daemon.node_of(session)
        if running is not None:
            with daemon.reporting_faults():
                yield running
            return
    unseen = through_daemon and daemon.is_running(session)
    node = await direct_node(session, args, f"{OBSERVER_PREFIX}{PREFIX}_{session.pid}" if unseen else None)
    try:
        with daemon.reporting_faults() if unseen else nullcontext():
            yield node
    finally:
        node.destroy_node()


async def appears(session: Session, is_there: Callable[[], bool], seconds: float | None) -> bool:
    """Wait for something in the graph, for ever if `seconds` is None; returns whether it has come."""
    deadline = None if seconds is None else session.clock.steady_ns() + int(seconds * 1e9)
    while not is_there():
        if deadline is not None and session.clock.steady_ns() >= deadline:
            return False
        await session.sleep(POLL_SECONDS)
    return True


def topics(node: Node, *, hidden: bool) -> list[tuple[str, list[str]]]:
    """Return `(name, types)` of all topics."""
    return [(name, types) for name, types in node.get_topic_names_and_types() if hidden or not is_hidden(name)]


def services(node: Node, *, hidden: bool) -> list[tuple[str, list[str]]]:
    """Return `(name, types)` of all services."""
    return [(name, types) for name, types in node.get_service_names_and_types() if hidden or not is_hidden(name)]


def node_names(node: Node, *, hidden: bool) -> list[str]:
    """Return the full names of all nodes; a name that two nodes share is in it twice."""
    return [
        f"{namespace.rstrip('/')}/{name}"
        for name, namespace in node.get_node_names_and_namespaces()
        if hidden or not name.startswith(HIDDEN_PREFIX)
    ]


def absolute(node_name: str) -> str:
    """Return a node's name with the leading slash that users often leave out."""
    return node_name if node_name.startswith("/") else f"/{node_name}"


def split_name(full_name: str) -> tuple[str, str]:
    """Return `(name, namespace)` of a node's full name."""
    namespace, _, name = absolute(full_name).rpartition("/")
    return name, namespace or "/"
