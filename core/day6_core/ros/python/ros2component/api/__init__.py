"""Component types, and components in containers."""

from __future__ import annotations

import subprocess
from collections.abc import Iterable, Iterator, Sequence
from typing import Any, NamedTuple

from ament_index_python.resources import get_resource, get_resources
from composition_interfaces.srv import ListNodes, LoadNode, UnloadNode
from rcl_interfaces.msg import Parameter
from ros2cli.node.service_calls import call
from ros2node.api import NodeName, get_service_server_info

from rclpy.node import NodeNameNonExistentError
from rclpy.parameter import get_parameter_value

COMPONENTS_RESOURCE_TYPE = "rclcpp_components"
_SECONDS = 5.0
_KINDS = ("list_nodes", "ListNodes"), ("load_node", "LoadNode"), ("unload_node", "UnloadNode")


class ComponentInfo(NamedTuple):
    """A component in a container: its number there, its node's full name."""

    uid: int
    name: str


def get_package_names_with_component_types() -> list[str]:
    """Return the packages that register component types."""
    return list(get_resources(COMPONENTS_RESOURCE_TYPE))


def get_package_component_types(*, package_name: str) -> list[str]:
    """Return the component types that a package registers, none for a package without."""
    try:
        text, _ = get_resource(COMPONENTS_RESOURCE_TYPE, package_name)
    except LookupError:
        return []
    return [line.partition(";")[0] for line in text.splitlines() if line]


def get_registered_component_types() -> list[tuple[str, list[str]]]:
    """Return every package that registers component types, with them."""
    return [(name, get_package_component_types(package_name=name)) for name in get_package_names_with_component_types()]


def get_components_in_containers(*, node: Any, remote_containers_node_names: Iterable[str]) -> dict[str, Any]:
    """Return for each container True and its components, or False and why they are not known."""
    return {
        name: get_components_in_container(node=node, remote_container_node_name=name)
        for name in remote_containers_node_names
    }


def get_components_in_container(*, node: Any, remote_container_node_name: str) -> tuple[bool, Any]:
    """Return True and a container's components, or False and why they are not known."""
    service = f"{remote_container_node_name}/_container/list_nodes"
    try:
        response = call(node, ListNodes, service, ListNodes.Request(), _SECONDS)
    except RuntimeError:
        return False, "No 'list_nodes' service found"
    return True, [
        ComponentInfo(number, name) for number, name in zip(response.unique_ids, response.full_node_names, strict=True)
    ]


def _parameters(texts: Sequence[str] | None) -> list[Parameter]:
    pairs = [text.partition(":=") for text in texts or ()]
    return [Parameter(name=name, value=get_parameter_value(string_value=value)) for name, _, value in pairs]


def load_component_into_container(
    *,
    node: Any,
    remote_container_node_name: str,
    package_name: str,
    plugin_name: str,
    node_name: str | None = None,
    node_namespace: str | None = None,
    log_level: int | None = None,
    remap_rules: Sequence[str] | None = None,
    parameters: Sequence[str] | None = None,
    extra_arguments: Sequence[str] | None = None,
) -> tuple[int, str]:
    """Load a component; return its number and its node's name. Raises RuntimeError."""
    given = {"node_name": node_name, "node_namespace": node_namespace, "log_level": log_level}
    request = LoadNode.Request(
        package_name=package_name,
        plugin_name=plugin_name,
        remap_rules=list(remap_rules or ()),
        parameters=_parameters(parameters),
        extra_arguments=_parameters(extra_arguments),
        **{name: value for name, value in given.items() if value is not None},
    )
    response = call(node, LoadNode, f"{remote_container_node_name}/_container/load_node", request, _SECONDS)
    if not response.success:
        raise RuntimeError(f"Failed to load component: {response.error_message.capitalize()}")
    return response.unique_id, response.full_node_name


def unload_component_from_container(
    *, node: Any, remote_container_node_name: str, component_uids: Iterable[int]
) -> Iterator[tuple[int, bool, str]]:
    """Unload components; yield each number, whether that failed, and why."""
    service = f"{remote_container_node_name}/_container/unload_node"
    for number in component_uids:
        response = call(node, UnloadNode, service, UnloadNode.Request(unique_id=number), _SECONDS)
        yield number, not response.success, response.error_message


def find_container_node_names(*, node: Any, node_names: Iterable[NodeName]) -> list[NodeName]:
    """Return those of some nodes that are containers."""

    def is_container(name: NodeName) -> bool:
        try:
            offered = get_service_server_info(node=node, remote_node_name=name.full_name, include_hidden=True)
        except NodeNameNonExistentError:
            return False
        return all(
            any(
                each.name.endswith(f"_container/{end}") and f"composition_interfaces/srv/{kind}" in each.types
                for each in offered
            )
            for end, kind in _KINDS
        )

    return [name for name in node_names if is_container(name)]


def run_standalone_container(*, container_node_name: str) -> subprocess.Popen[bytes]:
    """Start a container as a process."""
    words = ["ros2", "run", "rclcpp_components", "component_container", "--ros-args", "-r"]
    return subprocess.Popen([*words, f"__node:={container_node_name}"])
