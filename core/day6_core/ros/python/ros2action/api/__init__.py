"""Actions, asked of a node or of `ros2cli.node.strategy.NodeStrategy`."""

from __future__ import annotations

from typing import Any

from ros2cli.node.strategy import NodeStrategy
from rosidl_runtime_py import get_action_interfaces, message_to_yaml
from rosidl_runtime_py.utilities import get_action

from rclpy.expand_topic_name import expand_topic_name
from rclpy.validate_full_topic_name import validate_full_topic_name

NamesAndTypes = list[tuple[str, list[str]]]


def get_action_clients_and_servers(*, node: Any, action_name: str) -> tuple[NamesAndTypes, NamesAndTypes]:
    """Return the nodes with a client and those with a server of an action, each with its types."""
    wanted = expand_topic_name(action_name, node.get_name(), node.get_namespace())
    validate_full_topic_name(wanted)

    def owners(part: str) -> NamesAndTypes:
        ask = getattr(node, f"get_action_{part}_names_and_types_by_node")
        return [
            (f"{namespace}/{name}", types)
            for name, namespace in node.get_node_names_and_namespaces()
            for found, types in ask(name, namespace)
            if found == wanted
        ]

    return owners("client"), owners("server")


def get_action_names_and_types(*, node: Any) -> NamesAndTypes:
    """Return all actions with their types."""
    found: NamesAndTypes = node.get_action_names_and_types()
    return found


def get_action_names(*, node: Any) -> list[str]:
    """Return the names of all actions."""
    return [name for name, _ in get_action_names_and_types(node=node)]


def action_name_completer(prefix: str, parsed_args: Any, **kwargs: Any) -> list[str]:
    """Complete the name of an action."""
    with NodeStrategy(parsed_args) as node:
        return get_action_names(node=node)


def action_type_completer(**kwargs: Any) -> list[str]:
    """Complete the type of an action."""
    return [f"{package}/{name}" for package, names in get_action_interfaces().items() for name in names]


class ActionTypeCompleter:
    """Completes the type of an action: of the one that was named, else every type."""

    def __init__(self, *, action_name_key: str | None = None) -> None:
        self.action_name_key = action_name_key

    def __call__(self, prefix: str, parsed_args: Any, **kwargs: Any) -> list[str]:
        if self.action_name_key is None:
            return action_type_completer()
        with NodeStrategy(parsed_args) as node:
            found = dict(get_action_names_and_types(node=node))
        return found.get(getattr(parsed_args, self.action_name_key), [])


class ActionGoalPrototypeCompleter:
    """Completes a goal with its default values."""

    def __init__(self, *, action_type_key: str | None = None) -> None:
        self.action_type_key = action_type_key

    def __call__(self, prefix: str, parsed_args: Any, **kwargs: Any) -> list[str]:
        return [message_to_yaml(get_action(getattr(parsed_args, self.action_type_key or "")).Goal())]
