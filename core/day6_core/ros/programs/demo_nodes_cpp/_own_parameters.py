"""The demos of rclcpp's parameter clients: a node that sets, lists and gets its own parameters through the services."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from day6_core.ros.programs.demo_nodes_cpp._calls import value_text, wait_for_service
from day6_core.ros.programs.rclcpp import create_node
from day6_core.ros.programs.rclcpp.parameters import TYPE_NAMES
from rclpy.parameter import Parameter, parameter_value_to_python
from rclpy.parameter_client import AsyncParameterClient

if TYPE_CHECKING:
    from day6_core.session.session import Session

_Type = Parameter.Type


async def list_own(session: Session, name: str) -> int:
    """Set some parameters, then list those below `foo` and `bar`, ten levels deep."""
    node = create_node(session, name)
    start = {"foo": 0, "bar": "", "baz": 0.0, "foo.first": 0, "foo.second": 0, "foobar": False}
    for each, value in start.items():
        node.declare_parameter(each, value)
    client = AsyncParameterClient(node, node.get_fully_qualified_name())
    if not await wait_for_service(session, node, client.services_are_ready):
        return 0
    session.executor.add_node(node)
    node.get_logger().info("Setting parameters...")
    new = {"foo": 2, "bar": "hello", "baz": 1.45, "foo.first": 8, "foo.second": 42, "foobar": True}
    await session.spin_until(client.set_parameters([Parameter(each, value=value) for each, value in new.items()]))
    node.get_logger().info("Listing parameters...")
    future: Any = client.list_parameters(["foo", "bar"], 10)
    await session.spin_until(future)
    found = future.result().result
    # rclcpp keeps its parameters sorted.
    lines = ["", "Parameter names:", *(f" {each}" for each in sorted(found.names))]
    lines += ["Parameter prefixes:", *(f" {each}" for each in sorted(found.prefixes))]
    node.get_logger().info("\n".join(lines))
    return 0


async def set_and_get_own(session: Session, name: str) -> int:
    """Set some parameters of different types, then get four of them."""
    node = create_node(session, name)
    start: dict[str, tuple[_Type, Any, Any]] = {
        "foo": (_Type.INTEGER, 0, 2),
        "bar": (_Type.STRING, "", "hello"),
        "baz": (_Type.DOUBLE, 0.0, 1.45),
        "foobar": (_Type.BOOL, False, True),
        "foobarbaz": (_Type.BOOL_ARRAY, [], [True, False]),
        "toto": (_Type.BYTE_ARRAY, [], [b"\xff", b"\x7f"]),
    }
    for each, (kind, value, _) in start.items():
        # An empty list says nothing of its type.
        node.declare_parameter(each, kind if value == [] else value)
    client = AsyncParameterClient(node, node.get_fully_qualified_name())
    if not await wait_for_service(session, node, client.services_are_ready):
        return 0
    session.executor.add_node(node)
    future: Any = client.set_parameters([Parameter(each, kind, value) for each, (kind, _, value) in start.items()])
    await session.spin_until(future)
    for result in future.result().results:
        if not result.successful:
            node.get_logger().error(f"Failed to set parameter: {result.reason}")
    names = ["foo", "baz", "foobarbaz", "toto"]
    future = client.get_parameters(names)
    await session.spin_until(future)
    lines = [""]
    for each, value in zip(names, future.result().values, strict=True):
        text = value_text(value.type, parameter_value_to_python(value))
        lines += [f"Parameter name: {each}", f"Parameter value ({TYPE_NAMES[value.type]}): {text}"]
    node.get_logger().info("\n".join(lines))
    return 0
