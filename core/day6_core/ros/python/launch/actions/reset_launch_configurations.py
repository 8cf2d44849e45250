"""Clears launch configurations."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import TYPE_CHECKING, Any, List  # noqa: UP035

from launch.action import Action
from launch.frontend.entity import Entity
from launch.frontend.expose import expose_action
from launch.launch_description_entity import LaunchDescriptionEntity
from launch.some_substitutions_type import SomeSubstitutionsType
from launch.utilities import normalize_to_list_of_substitutions, perform_substitutions

if TYPE_CHECKING:
    from launch.frontend.parser import Parser
    from launch.launch_context import LaunchContext


@expose_action("reset")
class ResetLaunchConfigurations(Action):
    """Clears all launch configurations except the given ones."""

    def __init__(
        self,
        launch_configurations: Mapping[SomeSubstitutionsType, SomeSubstitutionsType] | None = None,
        **kwargs: Any,
    ) -> None:
        super().__init__(**kwargs)
        self.__kept = launch_configurations or {}

    @classmethod
    def parse(cls, entity: Entity, parser: Parser) -> tuple[Any, dict[str, Any]]:
        _, keywords = super().parse(entity, parser)
        keeps = entity.get_attr("keep", data_type=List[Entity], optional=True)  # noqa: UP006
        if keeps is not None:
            keywords["launch_configurations"] = kept_configurations(keeps, parser)
        return cls, keywords

    def execute(self, context: LaunchContext) -> Sequence[LaunchDescriptionEntity] | None:
        def text(value: SomeSubstitutionsType) -> str:
            return perform_substitutions(context, normalize_to_list_of_substitutions(value))

        kept = {text(name): text(value) for name, value in self.__kept.items()}
        context.launch_configurations.clear()
        context.launch_configurations.update(kept)
        return None


def kept_configurations(keeps: Sequence[Entity], parser: Parser) -> dict[Any, Any]:
    """Return `{name: value}` of the `keep` tags in a tag."""
    found = {
        tuple(parser.parse_substitution(each.get_attr("name"))): parser.parse_substitution(each.get_attr("value"))
        for each in keeps
    }
    for each in keeps:
        each.assert_entity_completely_parsed()
    return found
