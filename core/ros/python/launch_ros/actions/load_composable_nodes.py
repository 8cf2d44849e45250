"""Components for a container that runs already."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING, Any

from launch.action import Action
from launch.frontend.entity import Entity
from launch.frontend.expose import expose_action
from launch.launch_description_entity import LaunchDescriptionEntity
from launch.some_substitutions_type import SomeSubstitutionsType, SomeSubstitutionsType_types_tuple
from launch.utilities import ensure_argument_type, normalize_to_list_of_substitutions, perform_substitutions

from launch_ros.actions.composable_node_container import (
    ComposableNodeContainer,
    parsed_components,
    say_that_components_are_not_loaded,
)
from launch_ros.descriptions.composable_node import ComposableNode

if TYPE_CHECKING:
    from launch.frontend.parser import Parser
    from launch.launch_context import LaunchContext


@expose_action("load_composable_node")
class LoadComposableNodes(Action):
    """Says, like `ComposableNodeContainer`, that components cannot be loaded here."""

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
        self.__descriptions = composable_node_descriptions
        self.__target = target_container

    @classmethod
    def parse(cls, entity: Entity, parser: Parser) -> tuple[Any, dict[str, Any]]:
        _, keywords = super().parse(entity, parser)
        keywords["target_container"] = parser.parse_substitution(entity.get_attr("target"))
        keywords["composable_node_descriptions"] = parsed_components(entity, parser, optional=False)
        return cls, keywords

    def execute(self, context: LaunchContext) -> Sequence[LaunchDescriptionEntity] | None:
        if isinstance(self.__target, ComposableNodeContainer):
            name = self.__target.node_name
        else:
            name = perform_substitutions(context, normalize_to_list_of_substitutions(self.__target))
        say_that_components_are_not_loaded(context, name, self.__descriptions)
        return None
