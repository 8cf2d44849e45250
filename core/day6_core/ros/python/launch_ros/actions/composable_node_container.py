"""A container of components."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from typing import TYPE_CHECKING, Any, List  # noqa: UP035

from launch.frontend.entity import Entity
from launch.frontend.expose import expose_action
from launch.launch_description_entity import LaunchDescriptionEntity
from launch.some_substitutions_type import SomeSubstitutionsType

from launch_ros.actions.node import Node
from launch_ros.descriptions.composable_node import ComposableNode

if TYPE_CHECKING:
    from launch.frontend.parser import Parser
    from launch.launch_context import LaunchContext


@expose_action("node_container")
class ComposableNodeContainer(Node):
    """A container node, and the components that it loads once it runs.

    In real ROS components are C++ classes. The containers here have those of day6-tui's own packages (demo_nodes_cpp …); they
    report all others as failing to load.
    """

    def __init__(
        self,
        *,
        name: SomeSubstitutionsType,
        namespace: SomeSubstitutionsType,
        composable_node_descriptions: Sequence[ComposableNode] | None = None,
        **kwargs: Any,
    ) -> None:
        super().__init__(name=name, namespace=namespace, **kwargs)
        self.__composable_node_descriptions = list(composable_node_descriptions or ())

    @classmethod
    def parse(cls, entity: Entity, parser: Parser, ignore: Iterable[str] = ()) -> tuple[Any, dict[str, Any]]:
        _, keywords = super().parse(entity, parser, ignore)
        keywords["composable_node_descriptions"] = parsed_components(entity, parser, optional=True)
        return cls, keywords

    def execute(self, context: LaunchContext) -> Sequence[LaunchDescriptionEntity] | None:
        from launch_ros.actions.load_composable_nodes import LoadComposableNodes

        wanted = [
            each
            for each in self.__composable_node_descriptions
            if (test := each.condition()) is None or test.evaluate(context)
        ]
        following = list(super().execute(context) or ())
        if wanted:
            following.append(LoadComposableNodes(composable_node_descriptions=wanted, target_container=self))
        return following


def parsed_components(entity: Entity, parser: Parser, *, optional: bool) -> list[ComposableNode]:
    """Return the descriptions in the `composable_node` tags of a tag."""
    found = entity.get_attr("composable_node", data_type=List[Entity], optional=optional)  # noqa: UP006
    descriptions = []
    for each in found or ():
        kind, keywords = ComposableNode.parse(parser, each)
        descriptions.append(kind(**keywords))
    return descriptions
