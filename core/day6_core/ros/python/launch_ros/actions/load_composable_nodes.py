"""Loads components into a running container."""

from __future__ import annotations

import threading
from collections.abc import Iterator, Mapping, Sequence
from typing import TYPE_CHECKING, Any

import launch.logging
from launch.action import Action
from launch.frontend.entity import Entity
from launch.frontend.expose import expose_action
from launch.launch_description_entity import LaunchDescriptionEntity
from launch.some_substitutions_type import SomeSubstitutionsType, SomeSubstitutionsType_types_tuple
from launch.substitution import Substitution
from launch.utilities import ensure_argument_type, normalize_to_list_of_substitutions, perform_substitutions

from launch_ros.actions.composable_node_container import ComposableNodeContainer, parsed_components
from launch_ros.descriptions.composable_node import ComposableNode
from launch_ros.parameter_descriptions import Parameter
from launch_ros.ros_adapters import get_ros_node
from launch_ros.utilities import add_node_name, get_node_name_count, make_namespace_absolute, prefix_namespace
from launch_ros.utilities.evaluate_parameters import evaluate_parameter_dict, evaluate_parameters
from launch_ros.utilities.normalize_parameters import normalize_parameter_dict

if TYPE_CHECKING:
    from launch.frontend.parser import Parser
    from launch.launch_context import LaunchContext

_POLL = 0.2
"""Seconds between checks whether the launch has ended meanwhile."""


@expose_action("load_composable_node")
class LoadComposableNodes(Action):
    """Loads each component, one after the other, by the container's service `_container/load_node`.

    `target_container`: its full name, or the action that starts it.
    """

    def __init__(
        self,
        *,
        composable_node_descriptions: Sequence[ComposableNode],
        target_container: SomeSubstitutionsType | ComposableNodeContainer,
        **kwargs: Any,
    ) -> None:
        types = [*SomeSubstitutionsType_types_tuple, ComposableNodeContainer]
        ensure_argument_type(target_container, types, "target_container", "LoadComposableNodes")
        super().__init__(**kwargs)
        self.__composable_node_descriptions = composable_node_descriptions
        self.__target_container = (
            target_container
            if isinstance(target_container, ComposableNodeContainer)
            else normalize_to_list_of_substitutions(target_container)
        )
        self.__client: Any = None
        self.__container = ""
        self.__logger = launch.logging.get_logger(__name__)

    @classmethod
    def parse(cls, entity: Entity, parser: Parser) -> tuple[Any, dict[str, Any]]:
        _, keywords = super().parse(entity, parser)
        keywords["target_container"] = parser.parse_substitution(entity.get_attr("target"))
        keywords["composable_node_descriptions"] = parsed_components(entity, parser, optional=False)
        return cls, keywords

    def execute(self, context: LaunchContext) -> Sequence[LaunchDescriptionEntity] | None:
        from composition_interfaces.srv import LoadNode

        if isinstance(self.__target_container, ComposableNodeContainer):
            self.__container = self.__target_container.node_name
        else:
            self.__container = perform_substitutions(context, self.__target_container)
        self.__client = get_ros_node(context).create_client(LoadNode, f"{self.__container}/_container/load_node")
        # Now, because the scope of a group may end before the container responds.
        wanted = [get_composable_node_load_request(each, context) for each in self.__composable_node_descriptions]
        requests = [each for each in wanted if each is not None]
        if requests:
            future = context.asyncio_loop.run_in_executor(None, self.__load_all, requests, context)
            context.add_completion_future(future)
        return None

    def __load_all(self, requests: list[Any], context: LaunchContext) -> None:
        """Load the components one after the other; runs in a thread."""
        from rclpy._rclpy_pybind11 import InvalidHandle, RCLError

        try:
            for request in requests:
                self.__load(request, context)
        except (InvalidHandle, RCLError):
            if not context.is_shutdown:  # the end of the launch destroys its node
                raise

    def __load(self, request: Any, context: LaunchContext) -> None:
        while not self.__client.wait_for_service(timeout_sec=_POLL):
            if context.is_shutdown:
                self.__logger.warning(f"Abandoning wait for the '{self.__client.srv_name}' service, due to shutdown.")
                return
        self.__logger.debug(f"Calling the '{self.__client.srv_name}' service with request '{request}'")
        responded = threading.Event()
        future = self.__client.call_async(request)
        future.add_done_callback(lambda _: responded.set())
        while not responded.wait(_POLL):
            if context.is_shutdown:
                self.__logger.warning(
                    f"Abandoning wait for the '{self.__client.srv_name}' service response, due to shutdown."
                )
                future.cancel()
                return
        if future.exception() is not None:
            raise future.exception()
        self.__report(request, future.result(), context)

    def __report(self, request: Any, response: Any, context: LaunchContext) -> None:
        name = response.full_node_name or request.node_name
        if not response.success:
            self.__logger.error(
                f"Failed to load node '{name}' of type '{request.plugin_name}' in container '{self.__container}': "
                f"{response.error_message}"
            )
            return
        add_node_name(context, name)
        count = get_node_name_count(context, name)
        if count > 1:
            launch.logging.get_logger(self.__container).warning(
                f"there are now at least {count} nodes with the name {name} created within this launch context"
            )
        self.__logger.info(f"Loaded node '{response.full_node_name}' in container '{self.__container}'")


def get_composable_node_load_request(composable_node_description: ComposableNode, context: LaunchContext) -> Any:
    """Return the service request for a component: its own settings, and those of SetParameter, SetRemap, namespaces.

    None if its condition isn't met.
    """
    from composition_interfaces.srv import LoadNode

    description = composable_node_description
    condition = description.condition()
    if condition is not None and not condition.evaluate(context):
        return None

    def text(parts: list[Substitution] | None) -> str | None:
        return None if parts is None else perform_substitutions(context, parts)

    request = LoadNode.Request()
    request.package_name = text(description.package)
    request.plugin_name = text(description.node_plugin)
    request.node_name = text(description.node_name) or ""
    base = context.launch_configurations.get("ros_namespace")
    namespace = make_namespace_absolute(prefix_namespace(base, text(description.node_namespace)))
    request.node_namespace = namespace or ""
    everywhere = context.launch_configurations.get("ros_remaps") or []
    own = [tuple(perform_substitutions(context, side) for side in rule) for rule in description.remappings or ()]
    request.remap_rules = [f"{source}:={target}" for source, target in (*everywhere, *own)]
    request.parameters = _messages(context, _settings(context, description), request)
    request.extra_arguments = _messages(
        context, evaluate_parameters(context, description.extra_arguments or ()), request
    )
    return request


def _settings(context: LaunchContext, description: ComposableNode) -> list[Any]:
    common = context.launch_configurations.get("global_params") or []
    settings = [{each[0]: each[1]} if isinstance(each, tuple) else each for each in common]
    return [*settings, *evaluate_parameters(context, description.parameters or ())]


def _messages(context: LaunchContext, settings: Sequence[Any], request: Any) -> list[Any]:
    """Return evaluated parameters (dicts, `Parameter`s, the node's sections of files) as messages, in their order."""
    from rclpy.parameter import Parameter as RosParameter

    values = _values(context, settings, request)
    return [RosParameter(name, value=value).to_parameter_msg() for name, value, _ in values]


def _values(context: LaunchContext, settings: Sequence[Any], request: Any) -> Iterator[tuple[str, Any, str]]:
    """Yield name, value, and the file that it is from ('' for the launch file itself)."""
    node = f"{request.node_namespace}/{request.node_name}".strip("/")
    for each in settings:
        values: Mapping[str, Any]
        if isinstance(each, Mapping):
            values = each
        elif isinstance(each, Parameter):
            values = dict([each.evaluate(context)])
        else:
            values = _of_file(context, str(each), node)
        source = "" if isinstance(each, (Mapping, Parameter)) else str(each)
        for name, value in values.items():
            yield name, list(value) if isinstance(value, tuple) else value, source


def _sourced_parameters(
    context: LaunchContext, description: ComposableNode, request: Any
) -> dict[str, tuple[Any, str]]:
    """Return the parameters of a request: name -> the value that wins, and the file that it is from."""
    values = _values(context, _settings(context, description), request)
    return {name: (value, source) for name, value, source in values}


def _of_file(context: LaunchContext, path: str, node: str) -> dict[str, Any]:
    """Return what a parameter file has for a component: for all nodes, then for it; without nodes in it, all of it."""
    import yaml

    with open(path, encoding="utf-8") as file:
        values = yaml.safe_load(file) or {}
    sections = dict(_sections(values, ()))
    if sections:
        values = {**sections.get("**", {}), **sections.get(node, {})}
    return evaluate_parameter_dict(context, normalize_parameter_dict(values))


def _sections(values: Mapping[Any, Any], names: tuple[str, ...]) -> Iterator[tuple[str, Mapping[Any, Any]]]:
    for key, value in values.items():
        if key == "ros__parameters":
            yield "/".join(names), value
        elif isinstance(value, Mapping):
            yield from _sections(value, (*names, str(key).lstrip("/")))
