"""The parameters of a node, by its services."""

from __future__ import annotations

import sys
from typing import Any

from rcl_interfaces.msg import ParameterType
from ros2cli.node.direct import DirectNode

import rclpy
from rclpy.parameter import parameter_dict_from_yaml_file, parameter_value_to_python
from rclpy.parameter_client import AsyncParameterClient

_SERVICES_SECONDS = 5.0


def get_value(*, parameter_value: Any) -> Any:
    """Return a parameter's value as Python's."""
    try:
        return parameter_value_to_python(parameter_value)
    except RuntimeError as error:
        print(f"Runtime error {error} raised")
        return None


def _client(node: Any, node_name: str) -> AsyncParameterClient:
    client = AsyncParameterClient(node, node_name)
    if not client.wait_for_services(timeout_sec=_SERVICES_SECONDS):
        raise RuntimeError(f"Wait for service timed out waiting for parameter services for node {node_name}")
    return client


def _answer(node: Any, node_name: str, future: Any) -> Any:
    rclpy.spin_until_future_complete(node, future)
    if future.result() is None:
        raise RuntimeError(f"Exception while calling service of node {node_name}: {future.exception()}")
    return future.result()


def load_parameter_file(*, node: Any, node_name: str, parameter_file: str, use_wildcard: bool) -> None:
    """Set a node's parameters from a file, and print what came of each."""
    client = _client(node, node_name)
    future = client.load_parameter_file(parameter_file, use_wildcard)
    names = [each.name for each in parameter_dict_from_yaml_file(parameter_file, use_wildcard).values()]
    for name, result in zip(names, _answer(node, node_name, future).results, strict=True):
        end = f": {result.reason}" if result.reason else ""
        word, file = ("successful", sys.stdout) if result.successful else ("failed", sys.stderr)
        print(f"Set parameter {name} {word}{end}", file=file)


def call_describe_parameters(*, node: Any, node_name: str, parameter_names: Any = None) -> Any:
    """Return the response with a node's descriptors."""
    return _answer(node, node_name, _client(node, node_name).describe_parameters(parameter_names))


def call_get_parameters(*, node: Any, node_name: str, parameter_names: Any) -> Any:
    """Return the response with a node's values."""
    return _answer(node, node_name, _client(node, node_name).get_parameters(parameter_names))


def call_set_parameters(*, node: Any, node_name: str, parameters: Any) -> Any:
    """Set a node's parameters; return the response with what came of each."""
    return _answer(node, node_name, _client(node, node_name).set_parameters(parameters))


def call_list_parameters(*, node: Any, node_name: str, prefixes: Any = None) -> Any:
    """Return the future, done, of the response with a node's names; None if the node has no parameter services."""
    try:
        client = _client(node, node_name)
    except RuntimeError:
        return None
    future = client.list_parameters(prefixes=prefixes)
    rclpy.spin_until_future_complete(node, future)
    return future


_TYPES: dict[int, str] = {
    number: name.removeprefix("PARAMETER_").lower().replace("_", " ").replace("bool", "boolean")
    for name, number in vars(ParameterType).items()
    if name.startswith("PARAMETER_")
}


def get_parameter_type_string(parameter_type: int) -> str:
    """Return the name of a parameter's type, like 'double array'."""
    return _TYPES[parameter_type]


class ParameterNameCompleter:
    """Completes the name of a parameter of the node that was named."""

    def __call__(self, prefix: str, parsed_args: Any, **kwargs: Any) -> list[str]:
        with DirectNode(parsed_args) as node:
            future = call_list_parameters(node=node.node, node_name=parsed_args.node_name)
        names: list[str] = future.result().result.names if future is not None and future.result() else []
        return [name for name in names if name.startswith(prefix or "")]
