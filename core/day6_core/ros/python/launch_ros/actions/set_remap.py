"""Remaps a name for all nodes."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING, Any

from launch.action import Action
from launch.frontend.expose import expose_action
from launch.launch_description_entity import LaunchDescriptionEntity
from launch.some_substitutions_type import SomeSubstitutionsType
from launch.substitution import Substitution
from launch.utilities import normalize_to_list_of_substitutions, perform_substitutions

if TYPE_CHECKING:
    from launch.frontend.entity import Entity
    from launch.frontend.parser import Parser
    from launch.launch_context import LaunchContext


@expose_action("set_remap")
class SetRemap(Action):
    """Remaps `src` to `dst` for all later nodes (in this group)."""

    def __init__(self, src: SomeSubstitutionsType, dst: SomeSubstitutionsType, **kwargs: Any) -> None:
        super().__init__(**kwargs)
        self.__src = normalize_to_list_of_substitutions(src)
        self.__dst = normalize_to_list_of_substitutions(dst)

    @classmethod
    def parse(cls, entity: Entity, parser: Parser) -> tuple[Any, dict[str, Any]]:
        _, keywords = super().parse(entity, parser)
        for attribute, keyword in (("from", "src"), ("to", "dst")):
            keywords[keyword] = parser.parse_substitution(entity.get_attr(attribute))
        return cls, keywords

    @property
    def src(self) -> list[Substitution]:
        return self.__src

    @property
    def dst(self) -> list[Substitution]:
        return self.__dst

    def execute(self, context: LaunchContext) -> Sequence[LaunchDescriptionEntity] | None:
        before = context.launch_configurations.get("ros_remaps", [])
        pair = perform_substitutions(context, self.__src), perform_substitutions(context, self.__dst)
        context.launch_configurations["ros_remaps"] = [*before, pair]
        return None
