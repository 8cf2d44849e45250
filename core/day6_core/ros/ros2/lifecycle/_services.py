"""Finds lifecycle nodes and calls their services."""

from __future__ import annotations

from argparse import ArgumentParser, Namespace
from collections.abc import Iterable
from typing import TYPE_CHECKING, Any

from day6_core.ros.ros2.cli.node import appears, direct_node, graph_node, node_names, services
from day6_core.ros.ros2.cli.options import add_hidden_option, add_response_timeout, add_strategy_options, completed

if TYPE_CHECKING:
    from day6_core.ros.ros2.cli.completion import CompletionContext
    from day6_core.session.session import Session
    from rclpy.node import Node


def add_node_argument(
    parser: ArgumentParser, help_text: str = "Name of the ROS node", nargs: str | None = None
) -> None:
    """Add the strategy options, NODE_NAME and `--include-hidden-nodes`."""
    add_strategy_options(parser)
    completed(parser.add_argument("node_name", nargs=nargs, help=help_text), lifecycle_node_names)
    add_hidden_option(parser, "nodes")
    add_response_timeout(parser)


async def lifecycle_nodes(session: Session, args: Namespace, *, hidden: bool) -> list[str]:
    """Return the full names of the lifecycle nodes (those with a service `~/get_state` of the right type)."""
    async with graph_node(session, args) as node:
        return _with_lifecycle(node, hidden=hidden)


def _with_lifecycle(node: Node, *, hidden: bool) -> list[str]:
    offered = {name for name, types in services(node, hidden=hidden) if "lifecycle_msgs/srv/GetState" in types}
    return [name for name in node_names(node, hidden=hidden) if f"{name}/get_state" in offered]


class LifecycleServices:
    """The lifecycle services of nodes, called from this command's own node."""

    def __init__(self, session: Session, node: Node, limit: float | None = None) -> None:
        self.session = session
        self.node = node
        self.limit = limit
        """Seconds that a service may take to appear, and a response to come; for ever without one."""

    @classmethod
    async def of(cls, session: Session, args: Namespace) -> LifecycleServices:
        """Create the command's node."""
        node = await direct_node(session, args)
        session.executor.add_node(node)
        return cls(session, node, args.timeout)

    async def call(self, remote: str, service: str, kind: str, **fields: Any) -> Any:
        """Wait for a service of the node `remote`, call it and return the response.

        Without a limit it waits, like the real command, for ever if the service does not appear. Raises RuntimeError if the
        call fails or takes longer.
        """
        import lifecycle_msgs.srv

        client = self.node.create_client(getattr(lifecycle_msgs.srv, kind), f"{remote}/{service}")
        try:
            if not await appears(self.session, client.service_is_ready, self.limit):
                raise RuntimeError(f"Timed out waiting for {service} service (timeout: {self.limit}s)")
            future = client.call_async(client.srv_type.Request(**fields))
            if not await self.session.spin_until(future, self.limit):
                raise RuntimeError(f"Timed out waiting for {service} response (timeout: {self.limit}s)")
        finally:
            self.node.destroy_client(client)
        response = future.result()
        if response is None:
            raise RuntimeError(future.exception())
        return response

    async def transitions(self, remote: str, *, graph: bool = False) -> list[Any]:
        """Return the transitions possible now, or all (`graph`), as `lifecycle_msgs/msg/TransitionDescription`."""
        service = "get_transition_graph" if graph else "get_available_transitions"
        response = await self.call(remote, service, "GetAvailableTransitions")
        return list(response.available_transitions)


def lifecycle_node_names(context: CompletionContext) -> Iterable[str]:
    """Complete the name of a lifecycle node."""
    graph = context.session.graph
    if graph is None:
        return []
    return sorted(
        {
            f"{node.namespace.rstrip('/')}/{node.name}"
            for node in graph.nodes
            for endpoint in node.endpoints
            if endpoint.type_name == "lifecycle_msgs/srv/GetState" and endpoint.kind.value == "SS"
        }
    )


async def transition_labels(context: CompletionContext) -> Iterable[str]:
    """Complete a transition that is possible now in the node named before."""
    remote = context.values.get("node_name", "")
    if remote not in lifecycle_node_names(context):
        return []
    node = await direct_node(context.session)
    context.session.executor.add_node(node)
    try:
        found = await LifecycleServices(context.session, node).transitions(remote)
    finally:
        node.destroy_node()
    return [each.transition.label for each in found]
