"""The daemon, as commands use it: whether it runs, starting and stopping it, and asking it."""

from __future__ import annotations

from argparse import ArgumentParser
from collections.abc import Callable
from types import TracebackType
from typing import Any

from day6_core.graph.names import OBSERVER_PREFIX
from day6_core.ros.ros2.cli import lone_daemon
from day6_core.ros.ros2.cli.daemon import keywords, on_graph
from rclpy.context import Context
from rclpy.node import Node
from ros2cli.helpers import get_ros_domain_id
from ros2cli.node import NODE_NAME_PREFIX
from ros2cli.node.direct import settle

_METHODS = (
    *("count_clients", "count_publishers", "count_services", "count_subscribers", "get_action_names_and_types"),
    *("get_action_client_names_and_types_by_node", "get_action_server_names_and_types_by_node"),
    *("get_client_names_and_types_by_node", "get_name", "get_namespace", "get_node_names_and_namespaces"),
    *("get_node_names_and_namespaces_with_enclaves", "get_publisher_names_and_types_by_node"),
    *("get_publishers_info_by_topic", "get_service_names_and_types", "get_service_names_and_types_by_node"),
    *("get_subscriber_names_and_types_by_node", "get_subscriptions_info_by_topic", "get_topic_names_and_types"),
)


class DaemonNode:
    """What the daemon knows of the graph, with its answers as XML-RPC brings them: lists where a node has tuples.

    The real one asks a server. Here every process knows the graph at once, so that the answers come from this one, and the
    daemon only has to be there.
    """

    def __init__(self, args: Any) -> None:
        self._node: Node | None = None
        self.system = _System()

    @property
    def connected(self) -> bool:
        """Whether the daemon runs."""
        return is_daemon_running(None)

    @property
    def methods(self) -> list[str]:
        """What it answers."""
        return list(_METHODS)

    def __enter__(self) -> DaemonNode:
        context = Context()
        context.init(args=[])
        self._node = Node(f"{OBSERVER_PREFIX}{NODE_NAME_PREFIX}", context=context, **keywords())
        settle(self._node)
        return self

    def __getattr__(self, name: str) -> Callable[..., Any]:
        if name not in _METHODS:
            raise AttributeError(name)
        if self._node is None:
            raise RuntimeError("a DaemonNode is used in a `with` statement")
        if name == "get_name":
            return lambda: lone_daemon_name(self._node)
        import rclpy.action

        method = getattr(self._node, name, None)
        if method is None:
            function, node = getattr(rclpy.action, name), self._node
            return lambda *words: _as_sent(function(node, *words))
        answer: Callable[..., Any] = method
        return lambda *words: _as_sent(answer(*words))

    def __exit__(
        self,
        exc_type: type[BaseException] | None,
        exc_value: BaseException | None,
        traceback: TracebackType | None,
    ) -> None:
        if self._node is not None:
            self._node.destroy_node()
            self._node.context.try_shutdown()
            self._node = None


class _System:
    def shutdown(self) -> None:
        """End the daemon."""
        lone_daemon.shut_down(get_ros_domain_id())


def lone_daemon_name(node: Any) -> str:
    """Return the name of the daemon's node in a node's graph, '' if it is not there."""
    return next((name for name in node.get_node_names() if name.startswith(f"{NODE_NAME_PREFIX}_daemon_")), "")


def _as_sent(value: Any) -> Any:
    return [_as_sent(each) for each in value] if isinstance(value, (list, tuple)) else value


def is_daemon_running(args: Any) -> bool:
    """Return whether the daemon runs, be it a process of its own or the desktop's."""
    return bool(lone_daemon.running(get_ros_domain_id())) or on_graph()


def shutdown_daemon(args: Any, timeout: float | None = None) -> bool:
    """End the daemon, and wait for that up to `timeout` seconds; returns False if none runs that this process may end."""
    return lone_daemon.shut_down(get_ros_domain_id(), timeout)


def spawn_daemon(args: Any, timeout: float | None = None, debug: bool = False) -> bool:
    """Start the daemon and wait for it; returns False if it runs."""
    return not is_daemon_running(args) and lone_daemon.spawn(get_ros_domain_id(), timeout, debug=debug)


def add_arguments(parser: ArgumentParser) -> None:
    """It has none."""
