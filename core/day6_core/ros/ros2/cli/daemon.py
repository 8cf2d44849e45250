"""The daemon of `ros2`: a hidden node that outlives the commands, so that they know the graph at once.

Our commands don't need it (the desktop's graph is always there), but users see it: `ros2 daemon …`,
`/_ros2cli_daemon_0_…` in `node list -a`, its publisher in the count of /rosout. So it is a real node here too, one per
graph, in a process that outlives the command: the desktop, or where there is none `lone_daemon`.
"""

from __future__ import annotations

import os
from collections.abc import Iterator
from contextlib import contextmanager
from typing import TYPE_CHECKING, Any, NamedTuple
from weakref import WeakKeyDictionary

if TYPE_CHECKING:
    from day6_core.graph.graph import Graph
    from day6_core.session.session import Session
    from rclpy.context import Context
    from rclpy.node import Node

PREFIX = "_ros2cli_daemon"


class _Daemon(NamedTuple):
    context: Context
    node: Node


_daemons: WeakKeyDictionary[Graph, _Daemon] = WeakKeyDictionary()


@contextmanager
def reporting_faults() -> Iterator[None]:
    """Raise wrong names as xmlrpc's Fault, which is how the real daemon, a separate server, reports them back."""
    try:
        yield
    except Exception as error:
        from xmlrpc.client import Fault

        from rclpy.exceptions import NameValidationException

        if not isinstance(error, (ValueError, NameValidationException)):
            raise
        raise Fault(1, f"{type(error)}:{error}") from None


def is_running(session: Session) -> bool:
    """Return whether this machine has a daemon, ours or one in another process on the link."""
    if node_of(session) is not None:
        return True
    return session.graph is not None and _has_one(session.graph)


def on_graph() -> bool:
    """Return whether the graph of this process's domain has a daemon's node."""
    from day6_core.ros.ros2.cli.embedded import joined_graph

    with joined_graph() as graph:
        return _has_one(graph)


def _has_one(graph: Graph) -> bool:
    return any(node.name.startswith(f"{PREFIX}_") for node in graph.nodes)


def node_of(session: Session) -> Node | None:
    """Return the node of this process's daemon, None if it has none."""
    running = _daemons.get(session.graph) if session.graph is not None else None
    return running.node if running is not None else None


def start(session: Session) -> bool:
    """Start the daemon in this process; returns False if there is one already, or if this process ends with the command."""
    if session.graph is None or session.host is None or is_running(session):
        return False
    from rclpy.context import Context
    from rclpy.node import Node

    context = Context._for_session(session.graph, session.clock)
    _daemons[session.graph] = _Daemon(context, Node(node_name(session.graph.domain_id), context=context, **keywords()))
    return True


def node_name(domain_id: int) -> str:
    """Return a name for a daemon's node; no two have the same."""
    return f"{PREFIX}_{domain_id}_{os.urandom(16).hex()}"


def keywords() -> dict[str, Any]:
    """Return how a daemon's node is made."""
    from rclpy.parameter import Parameter

    return {
        "cli_args": [],
        "start_parameter_services": False,
        "parameter_overrides": [Parameter("start_type_description_service", value=False)],
    }


def stop(session: Session) -> bool:
    """Stop this process's daemon, or the one without a desktop; returns False if there is neither."""
    if session.graph is None:
        return False
    running = _daemons.pop(session.graph, None)
    if running is None:
        from day6_core.ros.ros2.cli.lone_daemon import shut_down

        return shut_down(session.graph.domain_id)
    running.node.destroy_node()
    running.context.try_shutdown()
    return True
