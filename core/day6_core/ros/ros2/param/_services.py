"""Calls the parameter services of a node; the arguments that all verbs of `ros2 param` share."""

from __future__ import annotations

from argparse import ArgumentParser, Namespace
from typing import TYPE_CHECKING, Any

from day6_core.ros.ros2.cli import completion
from day6_core.ros.ros2.cli.node import absolute, direct_node, graph_node, node_names
from day6_core.ros.ros2.cli.options import add_response_timeout, add_strategy_options, completed

if TYPE_CHECKING:
    from day6_core.session.session import Session
    from rclpy.node import Node

SERVICES_SECONDS = 5.0
POLL_SECONDS = 0.05
_SERVICES = {
    "DescribeParameters": "describe_parameters",
    "GetParameterTypes": "get_parameter_types",
    "GetParameters": "get_parameters",
    "ListParameters": "list_parameters",
    "SetParameters": "set_parameters",
    "SetParametersAtomically": "set_parameters_atomically",
}


def add_node_argument(parser: ArgumentParser, *, optional: bool = False) -> None:
    """Add the strategy options and NODE_NAME."""
    add_strategy_options(parser)
    completed(
        parser.add_argument("node_name", nargs="?" if optional else None, help="Name of the ROS node"),
        completion.node_names,
    )


def add_timeout_option(parser: ArgumentParser) -> None:
    """Add `--timeout`, the seconds to wait for the node, and `--service-timeout`, those to wait for its services' responses."""
    parser.add_argument(
        "--timeout",
        metavar="N",
        type=int,
        default=1,
        help="Wait for N seconds until node becomes available (default %(default)s sec)",
    )
    add_response_timeout(parser, "--service-timeout")


async def found_node(session: Session, args: Namespace) -> bool:
    """Wait up to `--timeout` seconds for the node to appear; a negative number waits for ever."""
    wanted = absolute(args.node_name)
    async with graph_node(session, args) as node:
        deadline = None if args.timeout < 0 else session.clock.steady_ns() + args.timeout * 1_000_000_000
        while wanted not in node_names(node, hidden=args.include_hidden_nodes):
            if deadline is not None and session.clock.steady_ns() > deadline:
                return False
            await session.sleep(POLL_SECONDS)
    return True


class ParameterServices:
    """The parameter services of one node, called from this command's own node."""

    def __init__(self, session: Session, node: Node, remote: str, limit: float | None = None) -> None:
        self.session = session
        self.node = node
        self.remote = remote
        self.limit = limit
        """Seconds that a response may take, for ever without one."""
        self._clients: dict[str, Any] = {}

    @classmethod
    async def of(cls, session: Session, args: Namespace, remote: str) -> ParameterServices:
        """Create the command's node."""
        node = await direct_node(session, args)
        session.executor.add_node(node)
        return cls(session, node, remote, getattr(args, "service_timeout", None))

    def for_node(self, remote: str) -> ParameterServices:
        """Return the services of another node, called from the same command's node."""
        return ParameterServices(self.session, self.node, remote, self.limit)

    async def ready(self, seconds: float = SERVICES_SECONDS) -> bool:
        """Wait until all six services are available; returns False after `seconds`."""
        import rcl_interfaces.srv

        for kind, service in _SERVICES.items():
            if kind not in self._clients:
                self._clients[kind] = self.node.create_client(
                    getattr(rcl_interfaces.srv, kind), f"{self.remote}/{service}"
                )
        deadline = self.session.clock.steady_ns() + int(seconds * 1e9)
        while not all(client.service_is_ready() for client in self._clients.values()):
            if self.session.clock.steady_ns() >= deadline:
                return False
            await self.session.sleep(POLL_SECONDS)
        return True

    async def call(self, kind: str, **fields: Any) -> Any:
        """Call a service and return its response.

        Raises TimeoutError if it takes longer than `limit`, RuntimeError if no services appear or the call fails.
        """
        if not await self.ready():
            raise RuntimeError(f"Wait for service timed out waiting for parameter services for node {self.remote}")
        client = self._clients[kind]
        future = client.call_async(client.srv_type.Request(**fields))
        if not await self.session.spin_until(future, self.limit):
            name = _SERVICES[kind]
            raise TimeoutError(
                f"Timed out waiting for {name} response from node {self.remote} (timeout: {self.limit}s)"
            )
        response = future.result()
        if response is None:
            raise RuntimeError(f"Exception while calling service of node {self.remote}: {future.exception()}")
        return response


def print_result(session: Session, result: Any, success: str, failure: str) -> None:
    """Print a node's result for a change of one parameter: failures go to stderr, the exit status stays 0."""
    reason = f": {result.reason}" if result.reason else ""
    if result.successful:
        session.print(success + reason)
    else:
        session.print_error(failure + reason)


async def listed_parameters(session: Session, node_name: str) -> list[str]:
    """Return the parameter names of a node (for Tab); empty if it doesn't exist or doesn't respond soon."""
    node = await direct_node(session)
    session.executor.add_node(node)
    try:
        services = ParameterServices(session, node, absolute(node_name))
        if not node_name or not await services.ready(0.2):
            return []
        return sorted((await services.call("ListParameters")).result.names)
    finally:
        node.destroy_node()
