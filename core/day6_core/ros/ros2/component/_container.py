"""Finds component containers and calls their services; the arguments for the component and its node."""

from __future__ import annotations

from argparse import ArgumentParser, Namespace
from collections.abc import AsyncIterator, Iterable
from contextlib import asynccontextmanager
from typing import TYPE_CHECKING, Any

from day6_core.graph.endpoints import EndpointKind
from day6_core.ros.ros2.cli.node import appears, direct_node, graph_node, node_names, split_name
from day6_core.ros.ros2.cli.options import completed
from day6_core.ros.ros2.component._index import package_names, type_names

if TYPE_CHECKING:
    from day6_core.ros.ros2.cli.completion import CompletionContext
    from day6_core.session.session import Session
    from rclpy.node import Node

POLL_SECONDS = 0.05
LONGEST_WAIT = 5.0
_SERVICES = {
    "LoadNode": "_container/load_node",
    "UnloadNode": "_container/unload_node",
    "ListNodes": "_container/list_nodes",
}


def add_container_argument(parser: ArgumentParser, help_text: str, nargs: str | None = None) -> None:
    """Add CONTAINER_NODE_NAME."""
    completed(parser.add_argument("container_node_name", nargs=nargs, help=help_text), container_names)


def add_component_arguments(parser: ArgumentParser) -> None:
    """Add PACKAGE_NAME and PLUGIN_NAME, and the options for the component's node."""
    completed(
        parser.add_argument("package_name", help="Name of the package where the component is to be found"),
        package_names,
    )
    completed(parser.add_argument("plugin_name", help="Type name of the component to be loaded"), type_names)
    parser.add_argument("-n", "--node-name", help="Component node name")
    parser.add_argument("--node-namespace", help="Component node namespace")
    parser.add_argument("--log-level", help="Component node log level")
    for short, long, name, help_text in (
        ("-r", "--remap-rule", "remap_rules", "Component node remapping rules, in the 'from:=to' form"),
        ("-p", "--parameter", "parameters", "Component node parameters, in the 'name:=value' form"),
        ("-e", "--extra-argument", "extra_arguments", "Extra arguments for the container, in the 'name:=value' form"),
    ):
        parser.add_argument(short, long, action="append", dest=name, help=help_text)


def container_names(context: CompletionContext) -> Iterable[str]:
    """Complete the name of a running container."""
    graph = context.session.graph
    found = graph.names_and_types(EndpointKind.SERVICE) if graph is not None else []
    ending = f"/{_SERVICES['LoadNode']}"
    return [name.removesuffix(ending) for name, _ in found if name.endswith(ending)]


async def containers(session: Session, args: Namespace) -> list[str]:
    """Return the full names of the nodes that have a container's three services."""
    async with graph_node(session, args) as node:
        return [name for name in node_names(node, hidden=False) if _is_container(node, name)]


def _is_container(node: Node, full_name: str) -> bool:
    offered = node.get_service_names_and_types_by_node(*split_name(full_name))
    return all(
        any(name.endswith(ending) and f"composition_interfaces/srv/{kind}" in types for name, types in offered)
        for kind, ending in _SERVICES.items()
    )


class Container:
    """The services of one container, called from this command's own node."""

    def __init__(self, session: Session, node: Node, name: str, limit: float | None = None) -> None:
        self.session = session
        self.node = node
        self.name = name
        self.limit = limit

    @classmethod
    @asynccontextmanager
    async def of(cls, session: Session, args: Namespace, name: str) -> AsyncIterator[Container]:
        """Create the command's node for calls to the container `name`; it is destroyed at the end of the context."""
        node = await direct_node(session, args)
        session.executor.add_node(node)
        try:
            yield cls(session, node, name, getattr(args, "timeout", None))
        finally:
            session.executor.remove_node(node)
            node.destroy_node()

    async def call(self, kind: str, request: Any = None) -> Any:
        """Call one of the three services. Raises TimeoutError if the service or its response does not come."""
        import composition_interfaces.srv

        client = self.node.create_client(getattr(composition_interfaces.srv, kind), f"{self.name}/{_SERVICES[kind]}")
        if not await appears(self.session, client.service_is_ready, self.limit or LONGEST_WAIT):
            raise TimeoutError("service found")
        future = client.call_async(client.srv_type.Request() if request is None else request)
        # A component may need a long time to load; without an option, only ListNodes has a time limit.
        limit = self.limit or (LONGEST_WAIT if kind == "ListNodes" else None)
        if not await self.session.spin_until(future, limit):
            raise TimeoutError("service response")
        return future.result()

    async def components(self) -> list[tuple[int, str]]:
        """Return `(number, full node name)` of the container's components. Raises TimeoutError, like `call`."""
        response = await self.call("ListNodes")
        return list(zip(response.unique_ids, response.full_node_names, strict=False))

    async def load(self, args: Namespace) -> tuple[int, str]:
        """Load the component named by the arguments; returns its number and node name. Raises RuntimeError if it fails."""
        try:
            response = await self.call("LoadNode", _load_request(args))
        except TimeoutError as error:
            raise RuntimeError(f"No 'load_node' {error} for '{self.name}' container") from None
        if not response.success:
            raise RuntimeError(f"Failed to load component: {response.error_message.capitalize()}")
        return response.unique_id, response.full_node_name

    async def unload(self, number: int) -> str | None:
        """Unload a component; returns the reason if that fails."""
        from composition_interfaces.srv import UnloadNode

        try:
            response = await self.call("UnloadNode", UnloadNode.Request(unique_id=number))
        except TimeoutError as error:
            raise RuntimeError(f"No 'unload_node' {error} for '{self.name}' container") from None
        return None if response.success else str(response.error_message)


def _load_request(args: Namespace) -> Any:
    from composition_interfaces.srv import LoadNode
    from rcl_interfaces.msg import Parameter

    from day6_core.ros.ros2.param._values import value_from_text

    def parameters(texts: list[str] | None) -> list[Parameter]:
        parts = [text.partition(":=") for text in texts or ()]
        return [Parameter(name=name, value=value_from_text(value)) for name, _, value in parts]

    request = LoadNode.Request(package_name=args.package_name, plugin_name=args.plugin_name)
    if args.node_name is not None:
        request.node_name = args.node_name
    if args.node_namespace is not None:
        request.node_namespace = args.node_namespace
    if args.log_level is not None:
        request.log_level = args.log_level
    request.remap_rules = args.remap_rules or []
    request.parameters = parameters(args.parameters)
    request.extra_arguments = parameters(args.extra_arguments)
    return request
