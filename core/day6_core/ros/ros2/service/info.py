"""`ros2 service info`."""

from __future__ import annotations

from argparse import ArgumentParser, Namespace
from typing import TYPE_CHECKING, NamedTuple

from day6_core.ros.differences import value
from day6_core.ros.ros2.cli.completion import service_names
from day6_core.ros.ros2.cli.node import graph_node, services
from day6_core.ros.ros2.cli.options import add_strategy_options, completed

if TYPE_CHECKING:
    from day6_core.graph.endpoints import Endpoint
    from day6_core.session.session import Session

SUMMARY = "Print information about a service"


def add_arguments(parser: ArgumentParser) -> None:
    add_strategy_options(parser)
    completed(
        parser.add_argument("service_name", help="Name of the ROS service to get info (e.g. '/add_two_ints')"),
        service_names,
    )
    if value("service.info_verbose"):
        parser.add_argument(
            "-v",
            "--verbose",
            action="store_true",
            help="Also print node, type hash, GIDs and QoS of clients and servers",
        )


async def main(session: Session, args: Namespace) -> str | None:
    async with graph_node(session, args) as node:
        name = args.service_name
        types = dict(services(node, hidden=args.include_hidden_services)).get(name)
        if types is None:
            return f"Unknown service '{name}'"
        session.print(f"Type: {types[0] if len(types) == 1 else types}")
        verbose = value("service.info_verbose") and args.verbose
        clients, servers = node._rclpy_graph._endpoints_of_service(name) if verbose else ([], [])
        session.print(f"Clients count: {node.count_clients(name)}")
        for client in clients:
            session.print(_details(client, "CLIENT", _Half("Response Reader", 4), _Half("Request Writer", 3)))
        session.print(f"Services count: {node.count_services(name)}")
        for server in servers:
            session.print(_details(server, "SERVER", _Half("Request Reader", 4), _Half("Response Writer", 3)))
    return None


class _Half(NamedTuple):
    """A reader or a writer of a service; `kind` is the last number of its GID."""

    name: str
    kind: int


def _details(endpoint: Endpoint, kind: str, *halves: _Half) -> str:
    """Return what is known of a client or server, as rclpy's ServiceEndpointInfo prints it."""
    from rclpy.qos import QoSProfile

    profile = QoSProfile._from_graph(endpoint.qos, known_history=True)
    lines = [
        f"Node name: {endpoint.node.name}",
        f"Node namespace: {endpoint.node.namespace}",
        f"Service type: {endpoint.type_name}",
        f"Service type hash: {endpoint.type_hash}",
        f"Endpoint type: {kind}",
        f"Endpoint count: {len(halves)}",
        "GIDs:",
        *(f"- {half.name} : {_gid(endpoint, half)}" for half in halves),
        "QoS profiles:",
    ]
    for half in halves:
        lines += [
            f"- {half.name} :",
            f"      Reliability: {profile.reliability.name}",
            f"      History (Depth): {profile.history.name} ({profile.depth})",
            f"      Durability: {profile.durability.name}",
            f"      Lifespan: {profile.lifespan}",
            f"      Deadline: {profile.deadline}",
            f"      Liveliness: {profile.liveliness.name}",
            f"      Liveliness lease duration: {profile.liveliness_lease_duration}",
        ]
    return "\n".join(lines)


def _gid(endpoint: Endpoint, half: _Half) -> str:
    return ".".join(f"{each:02x}" for each in (*endpoint.gid.ljust(16, b"\0")[:15], half.kind))
