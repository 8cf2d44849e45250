"""The daemon of `ros2`: a hidden node that outlives the commands, so that they know the graph at once.

Our commands don't need it (the desktop's graph is always there), but users see it: `ros2 daemon …`,
`/_ros2cli_daemon_0_…` in `node list -a`, its publisher in the count of /rosout. So it is a real node here too, one per
graph, in a process that outlives the command; a command in a terminal of its own has no such process.
"""

from __future__ import annotations

import os
from collections.abc import Iterator
from contextlib import contextmanager
from typing import TYPE_CHECKING, NamedTuple
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
    return session.graph is not None and any(node.name.startswith(f"{PREFIX}_") for node in session.graph.nodes)


def node_of(session: Session) -> Node | None:
    """Return the node of this process's daemon, None if it has none."""
    running = _daemons.get(session.graph) if session.graph is not None else None
    return running.node if running is not None else None


def can_run(session: Session) -> bool:
    """Return whether this process outlives the command (the desktop does, `day6-tui ros2 …` does not)."""
    return session.graph is not None and session.host is not None


def start(session: Session) -> bool:
    """Start the daemon; returns False if there is one already, or if this process ends with the command."""
    if is_running(session) or not can_run(session) or session.graph is None:
        return False
    from rclpy.context import Context
    from rclpy.node import Node
    from rclpy.parameter import Parameter

    context = Context._for_session(session.graph, session.clock)
    node = Node(
        f"{PREFIX}_{session.graph.domain_id}_{os.urandom(16).hex()}",
        context=context,
        cli_args=[],
        start_parameter_services=False,
        parameter_overrides=[Parameter("start_type_description_service", value=False)],
    )
    _daemons[session.graph] = _Daemon(context, node)
    return True


def stop(session: Session) -> bool:
    """Stop this process's daemon; returns False if it has none."""
    running = _daemons.pop(session.graph, None) if session.graph is not None else None
    if running is None:
        return False
    running.node.destroy_node()
    running.context.try_shutdown()
    return True
