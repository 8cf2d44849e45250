"""The two demos that subscribe to /parameter_events for changes of their own parameters."""

from __future__ import annotations

from collections.abc import Callable
from typing import TYPE_CHECKING, Any

from rcl_interfaces.msg import ParameterEvent

from day6_core.ros.programs.demo_nodes_cpp._calls import wait_for_service
from day6_core.ros.programs.rclcpp import STOPPED, create_node, log_interrupt
from rclpy.parameter import Parameter
from rclpy.parameter_client import AsyncParameterClient
from rclpy.qos import qos_profile_parameter_events
from rclpy.task import Future

if TYPE_CHECKING:
    from day6_core.session.session import Session
    from rclpy.node import Node

START = {"foo": 0, "bar": "", "baz": 0.0, "foobar": False}
FIRST = {"foo": 2, "bar": "hello", "baz": 1.45, "foobar": True}
SECOND = {"foo": 3, "bar": "world"}
EVENTS = len(START) + len(FIRST) + len(SECOND)
"""One for each parameter declared or set."""


async def hear_ten(session: Session, name: str) -> int:
    """Declare four parameters, set them, set two of them again; end when all of that was heard."""
    heard: Future[bool] = Future()
    count = 0

    def count_one() -> None:
        nonlocal count
        count += 1
        if count == EVENTS:
            heard.set_result(True)

    node = _hearing_node(session, name, count_one)
    client = AsyncParameterClient(node, node.get_fully_qualified_name())
    if not await wait_for_service(session, node, client.services_are_ready):
        return 0
    session.executor.add_node(node)
    _declare(node)
    try:
        for values in (FIRST, SECOND):
            await session.spin_until(client.set_parameters(_parameters(values)))
        await session.spin_until(heard)
    except STOPPED:
        log_interrupt(session)
    return 0


async def hear_all(session: Session, name: str) -> int:
    """Hear all changes, with pauses: the first comes 0.2 s after the start, the end 0.1 s after the last."""
    node = _hearing_node(session, name, lambda: None)
    client = AsyncParameterClient(node, node.get_fully_qualified_name())
    if not await wait_for_service(session, node, client.services_are_ready):
        return 0
    session.executor.add_node(node)
    _declare(node)
    pause: Future[bool] = Future()
    try:
        await session.spin_until(pause, 0.2)
        for values in (FIRST, SECOND):
            future: Any = client.set_parameters(_parameters(values))
            await session.spin_until(future)
            for result in future.result().results:
                if not result.successful:
                    node.get_logger().error(f"Failed to set parameter: {result.reason}")
        await session.spin_until(pause, 0.1)
    except STOPPED:
        log_interrupt(session)
    return 0


def _hearing_node(session: Session, name: str, on_event: Callable[[], None]) -> Node:
    node = create_node(session, name)

    def hear(event: ParameterEvent) -> None:
        if event.node != node.get_fully_qualified_name():
            return
        sections = {
            "new": [each.name for each in event.new_parameters if not each.name.startswith("qos_overrides.")],
            "changed": [each.name for each in event.changed_parameters],
            "deleted": [each.name for each in event.deleted_parameters],
        }
        if any(sections.values()):
            lines = ["", "Parameter event:"]
            for what, names in sections.items():
                lines += [f" {what} parameters:", *(f"  {each}" for each in names)]
            node.get_logger().info("\n".join([*lines, ""]))
            on_event()

    node.create_subscription(ParameterEvent, "/parameter_events", hear, qos_profile_parameter_events)
    return node


def _declare(node: Node) -> None:
    for name, value in START.items():
        node.declare_parameter(name, value)


def _parameters(values: dict[str, Any]) -> list[Parameter[Any]]:
    return [Parameter(name, value=value) for name, value in values.items()]
