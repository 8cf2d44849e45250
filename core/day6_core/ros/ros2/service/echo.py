"""`ros2 service echo`: the requests and responses of a service that has introspection switched on."""

from __future__ import annotations

from argparse import ArgumentParser, Namespace
from typing import TYPE_CHECKING, Any

from day6_core.ros.ros2.cli.completion import service_names, service_types_of_service
from day6_core.ros.ros2.cli.events import EventPrinter, add_printing_options
from day6_core.ros.ros2.cli.node import direct_node, graph_node
from day6_core.ros.ros2.cli.options import add_qos_options, completed

if TYPE_CHECKING:
    from day6_core.session.session import Session
    from rclpy.node import Node

SUMMARY = "Echo a service"
EVENT_TOPIC = "/_service_event"


def add_arguments(parser: ArgumentParser) -> None:
    completed(
        parser.add_argument("service_name", help="Name of the ROS service to echo (e.g. '/add_two_ints')"),
        service_names,
    )
    completed(
        parser.add_argument(
            "service_type", nargs="?", help="Type of the ROS service (e.g. 'example_interfaces/srv/AddTwoInts')"
        ),
        service_types_of_service,
    )
    add_printing_options(parser)
    add_qos_options(parser, "service introspection", "services_default")


async def main(session: Session, args: Namespace) -> None:
    from day6_core.ros.ros2.cli.qos import profile_from_options

    if args.service_type is None:
        async with graph_node(session, args) as query_node:
            kind = _class_of_service(query_node, args.service_name)
    else:
        kind = _class_of_type(args.service_type)
    topic = args.service_name + EVENT_TOPIC
    printer = EventPrinter(session, args)
    node = await direct_node(session, args)
    profile = profile_from_options(args)
    subscription = node.create_subscription(kind.Event, topic, printer.receive, profile)
    if subscription.get_publisher_count() < 1:
        session.print(f"No publishers on topic '{topic}'; is service introspection on the client or server enabled?")
    await session.spin(node)


def _class_of_service(node: Node, name: str) -> Any:
    """Return the class of a service in the graph. Raises RuntimeError if it is missing or has several or unknown types."""
    types = dict(node.get_service_names_and_types()).get(name)
    if types is None:
        raise RuntimeError(f"Cannot find type for '{name}'")
    if len(types) > 1:
        raise RuntimeError(f"More than one type associated with service '{name}'")
    return _class_of_type(types[0])


def _class_of_type(type_name: str) -> Any:
    from rosidl_runtime_py.utilities import get_service

    try:
        return get_service(type_name)
    except (AttributeError, ModuleNotFoundError, ValueError):
        raise RuntimeError(f"The service type '{type_name}' is invalid") from None
