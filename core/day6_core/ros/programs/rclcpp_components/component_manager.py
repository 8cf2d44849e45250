"""The node of a container: loads, lists and unloads components (rclcpp_components/component_manager.cpp).

In real ROS a component is a C++ class in a shared library. Here it is a class of day6-tui's own packages, found by the same
resource of the ament index: a line `package::Class;lib/libNAME.so`. The class is in the package's `_components.py`; the library
is only named, where real ROS has it, as nothing opens it.
"""

from __future__ import annotations

import importlib
import os
from pathlib import Path
from typing import TYPE_CHECKING, Any

from ament_index_python.search_paths import BUILT_IN_PREFIX, get_search_paths
from composition_interfaces.srv import ListNodes, LoadNode, UnloadNode
from rcl_interfaces.msg import IntegerRange, ParameterDescriptor

from day6_core.ros import distribution
from day6_core.ros.programs.rclcpp import create_node
from rclpy.parameter import Parameter

if TYPE_CHECKING:
    from day6_core.ros.programs._component import Component
    from day6_core.session.session import Session
    from rclpy.node import Node

_RESOURCES = Path("share", "ament_index", "resource_index", "rclcpp_components")


class LoadError(Exception):
    """A component cannot be loaded; the text is the response's."""


class ComponentManager:
    """Keeps the loaded nodes by their numbers. Runs them all in the executor of its session."""

    def __init__(self, session: Session, name: str = "ComponentManager") -> None:
        self.session = session
        self.node = create_node(session, name, start_parameter_services=False, start_parameter_event_publisher=False)
        self.loaded: dict[int, tuple[Node, Component]] = {}
        self._libraries: set[str] = set()
        self._last = 0
        self.node.create_service(LoadNode, "~/_container/load_node", self._on_load)
        self.node.create_service(UnloadNode, "~/_container/unload_node", self._on_unload)
        self.node.create_service(ListNodes, "~/_container/list_nodes", self._on_list)
        threads = os.cpu_count() or 1
        self.node.declare_parameter(
            "thread_num",
            threads,
            ParameterDescriptor(
                description="Number of thread",
                integer_range=[IntegerRange(from_value=1, to_value=threads)],
                read_only=True,
            ),
        )

    def _on_load(self, request: Any, response: Any) -> Any:
        try:
            kind = self._class(request.package_name, request.plugin_name)
            node, component = self._instance(kind, request)
        except LoadError as error:
            self.node.get_logger().error(str(error))
            response.error_message = str(error)
            return response
        self._last += 1
        self.loaded[self._last] = (node, component)
        self.session.executor.add_node(node)
        response.success = True
        response.unique_id = self._last
        response.full_node_name = node.get_fully_qualified_name()
        return response

    def _on_unload(self, request: Any, response: Any) -> Any:
        node, _ = self.loaded.pop(request.unique_id, (None, None))
        if node is None:
            response.error_message = f"No node found with unique_id: {request.unique_id}"
            self.node.get_logger().warning(response.error_message)
            return response
        self.session.executor.remove_node(node)
        node.destroy_node()
        response.success = True
        return response

    def _on_list(self, request: Any, response: Any) -> Any:
        response.unique_ids = list(self.loaded)
        response.full_node_names = [node.get_fully_qualified_name() for node, _ in self.loaded.values()]
        return response

    def _class(self, package: str, plugin: str) -> type[Component]:
        prefix, files = self._resource(package, plugin)
        if plugin not in files:
            self.node.get_logger().error(
                f"Failed to find class with the requested plugin name '{plugin}' in the loaded library"
            )
            raise LoadError("Failed to find class with the requested plugin name.")
        if prefix != BUILT_IN_PREFIX:
            raise LoadError(
                f"Failed to load library: {Path(prefix) / files[plugin]} is C++, and day6-tui runs no C++: a container here "
                "takes the components that came with day6-tui"
            )
        logger = self.node.get_logger()
        library = f"/opt/ros/{distribution.current()}/{files[plugin]}"
        if library not in self._libraries:
            logger.info(f"Load Library: {library}")
            self._libraries.add(library)
        module = importlib.import_module(f"day6_core.ros.programs.{package}._components")
        kind: type[Component] = module.COMPONENTS[plugin]
        logger.info(f"Found class: rclcpp_components::NodeFactoryTemplate<{plugin}>")
        logger.info(f"Instantiate class: rclcpp_components::NodeFactoryTemplate<{plugin}>")
        return kind

    def _resource(self, package: str, plugin: str) -> tuple[str, dict[str, str]]:
        """Return where a package lists its components, and their libraries; ours counts before one whose C++ was left out."""
        found: list[tuple[str, dict[str, str]]] = []
        for prefix in get_search_paths(self.session.env):
            file = Path(prefix) / _RESOURCES / package
            if package and file.is_file():
                lines = file.read_text(encoding="utf-8").splitlines()
                found.append((prefix, dict(line.split(";", 1) for line in lines if ";" in line)))
        if not found:
            raise LoadError("Could not find requested resource in ament index")
        return next((each for each in found if each[0] == BUILT_IN_PREFIX and plugin in each[1]), found[0])

    def _instance(self, kind: type[Component], request: Any) -> tuple[Node, Component]:
        rules = list(request.remap_rules)
        if request.node_name:
            rules.append(f"__node:={request.node_name}")
        if request.node_namespace:
            rules.append(f"__ns:={request.node_namespace}")
        arguments = ["--ros-args", *(word for rule in rules for word in ("-r", rule))]
        overrides = [Parameter.from_parameter_msg(each) for each in request.parameters]
        try:
            node = create_node(
                self.session,
                kind.NAME,
                use_global_arguments=False,
                cli_args=arguments,
                parameter_overrides=overrides,
                **kind.OPTIONS,
            )
        except Exception as error:
            raise LoadError(f"Component constructor threw an exception: {error}") from error
        try:
            return node, kind(node)
        except Exception as error:
            node.destroy_node()
            raise LoadError(f"Component constructor threw an exception: {error}") from error


async def run_container(session: Session) -> int:
    """Run as a container until Ctrl-C."""
    from day6_core.ros.programs.rclcpp import STOPPED, log_interrupt

    manager = ComponentManager(session)
    try:
        await session.spin(manager.node)
    except STOPPED:
        log_interrupt(session)
    return 0
