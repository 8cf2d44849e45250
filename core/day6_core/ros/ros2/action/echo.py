"""`ros2 action echo` (ros2cli 0.38, ROS 2 Kilted): the messages between the clients and the server of an action."""

from __future__ import annotations

from argparse import ArgumentParser, Namespace
from functools import partial
from typing import TYPE_CHECKING, Any

from day6_core.ros.ros2.cli.completion import action_names, action_types_of_action
from day6_core.ros.ros2.cli.events import EventPrinter, add_printing_options
from day6_core.ros.ros2.cli.node import direct_node, graph_node
from day6_core.ros.ros2.cli.options import add_qos_options, completed

if TYPE_CHECKING:
    from day6_core.session.session import Session
    from rclpy.node import Node

SUMMARY = "Echo a action"
INTERFACES = {
    "GOAL_SERVICE": "send_goal/_service_event",
    "CANCEL_SERVICE": "cancel_goal/_service_event",
    "RESULT_SERVICE": "get_result/_service_event",
    "FEEDBACK_TOPIC": "feedback",
    "STATUS_TOPIC": "status",
}


def add_arguments(parser: ArgumentParser) -> None:
    completed(
        parser.add_argument("action_name", help="Name of the ROS action to echo (e.g. '/fibonacci')"), action_names
    )
    completed(
        parser.add_argument(
            "action_type", nargs="?", help="Type of the ROS action (e.g. 'example_interfaces/action/Fibonacci')"
        ),
        action_types_of_action,
    )
    parser.add_argument(
        "--interfaces",
        "-i",
        metavar="interfaces_name_list",
        help='Specify a action interfaces list are output. "|" is used as a delimiter for multiple action interfaces. '
        'Action interfaces include "GOAL_SERVICE", "CANCEL_SERVICE", "RESULT_SERVICE", "FEEDBACK_TOPIC" and '
        '"STATUS_TOPIC". If this option is not set, output messages from all interfaces of the action.',
    )
    add_printing_options(parser)
    add_qos_options(parser, "action introspection", "services_default")


async def main(session: Session, args: Namespace) -> str | None:
    wanted = list(INTERFACES)
    if args.interfaces is not None:
        if not args.interfaces:
            return "Input action interface name is empty."
        wanted = [word.strip().upper() for word in args.interfaces.split("|")]
        for word, name in zip(args.interfaces.split("|"), wanted, strict=True):
            if name not in INTERFACES:
                return f'"{word.strip()}" is incorrect interface name.'
    if args.action_type is None:
        async with graph_node(session, args) as query_node:
            kind = _class_of_type(_type_of_action(query_node, args.action_name))
    else:
        kind = _class_of_type(args.action_type)
    printer = EventPrinter(session, args)
    node = await direct_node(session, args)
    for name in INTERFACES:
        if name in wanted:
            _subscribe(node, kind, args, name, printer)
    try:
        await session.spin(node)
    except KeyboardInterrupt:
        return None
    return None


def _subscribe(node: Node, kind: Any, args: Namespace, interface: str, printer: EventPrinter) -> None:
    from day6_core.ros.ros2.cli.qos import profile_from_options
    from rclpy.qos import QoSProfile, qos_profile_action_status_default

    messages, profile = {
        "GOAL_SERVICE": (kind.Impl.SendGoalService.Event, profile_from_options(args)),
        "CANCEL_SERVICE": (kind.Impl.CancelGoalService.Event, profile_from_options(args)),
        "RESULT_SERVICE": (kind.Impl.GetResultService.Event, profile_from_options(args)),
        "FEEDBACK_TOPIC": (kind.Impl.FeedbackMessage, QoSProfile(depth=10)),
        "STATUS_TOPIC": (kind.Impl.GoalStatusMessage, qos_profile_action_status_default),
    }[interface]
    receive = partial(_receive, printer, f"interface: {interface}\n")
    node.create_subscription(messages, f"{args.action_name}/_action/{INTERFACES[interface]}", receive, profile)


def _receive(printer: EventPrinter, heading: str, message: Any) -> None:
    printer.receive(message, heading)


def _type_of_action(node: Node, name: str) -> str:
    from rclpy.action import get_action_names_and_types

    types = dict(get_action_names_and_types(node)).get(name)
    if types is None:
        raise RuntimeError(f"Cannot find type for '{name}'")
    if len(types) > 1:
        raise RuntimeError(f"More than one type associated with action '{name}'")
    return str(types[0])


def _class_of_type(type_name: str) -> Any:
    from rosidl_runtime_py.utilities import get_action

    try:
        return get_action(type_name)
    except (AttributeError, ModuleNotFoundError, ValueError):
        raise RuntimeError(f"The service type '{type_name}' is invalid") from None
