"""A container of components."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from typing import TYPE_CHECKING, Any, List  # noqa: UP035

import launch.logging
from launch.frontend.entity import Entity
from launch.frontend.expose import expose_action
from launch.launch_description_entity import LaunchDescriptionEntity
from launch.some_substitutions_type import SomeSubstitutionsType
from launch.utilities import perform_substitutions

from launch_ros.actions.node import Node
from launch_ros.descriptions.composable_node import ComposableNode

if TYPE_CHECKING:
    from launch.frontend.parser import Parser
    from launch.launch_context import LaunchContext


def say_that_components_are_not_loaded(
    context: LaunchContext, container: str, descriptions: Iterable[ComposableNode]
) -> None:
    """Log an error with the names of the plugins. The rest of the launch goes on."""
    wanted = [each for each in descriptions if (condition := each.condition()) is None or condition.evaluate(context)]
    plugins = ", ".join(perform_substitutions(context, each.node_plugin) for each in wanted) or "none"
    launch.logging.get_logger("launch").error(
        f"container '{container}' was not started (its components: {plugins}): components are C++ libraries, and day6-tui "
        "runs Python nodes and its own programs only. Launch a Node with an executable instead."
    )


@expose_action("node_container")
class ComposableNodeContainer(Node):
    """In real ROS a process that loads C++ libraries. There are none here: executing it says so, and starts nothing."""

    def __init__(
        self,
        *,
        name: SomeSubstitutionsType,
        namespace: SomeSubstitutionsType,
        composable_node_descriptions: Sequence[ComposableNode] | None = None,
        **kwargs: Any,
    ) -> None:
        super().__init__(name=name, namespace=namespace, **kwargs)
        self.__descriptions = list(composable_node_descriptions or ())

    @classmethod
    def parse(cls, entity: Entity, parser: Parser, ignore: Iterable[str] = ()) -> tuple[Any, dict[str, Any]]:
        _, keywords = super().parse(entity, parser, ignore)
        keywords["composable_node_descriptions"] = parsed_components(entity, parser, optional=True)
        return cls, keywords

    def execute(self, context: LaunchContext) -> Sequence[LaunchDescriptionEntity] | None:
        self._perform_substitutions(context)
        say_that_components_are_not_loaded(context, self.node_name, self.__descriptions)
        return None


def parsed_components(entity: Entity, parser: Parser, *, optional: bool) -> list[ComposableNode]:
    """Return what the `composable_node` tags in a tag say."""
    found = entity.get_attr("composable_node", data_type=List[Entity], optional=optional)  # noqa: UP006
    descriptions = []
    for each in found or ():
        kind, keywords = ComposableNode.parse(parser, each)
        descriptions.append(kind(**keywords))
    return descriptions
