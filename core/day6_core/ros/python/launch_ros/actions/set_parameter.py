"""Sets a parameter of all nodes."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING, Any

from launch.action import Action
from launch.frontend.expose import expose_action
from launch.launch_description_entity import LaunchDescriptionEntity
from launch.some_substitutions_type import SomeSubstitutionsType
from launch.utilities import normalize_to_list_of_substitutions

from launch_ros.utilities.evaluate_parameters import evaluate_parameter_dict
from launch_ros.utilities.normalize_parameters import normalize_parameter_dict

if TYPE_CHECKING:
    from launch.frontend.entity import Entity
    from launch.frontend.parser import Parser
    from launch.launch_context import LaunchContext


@expose_action("set_parameter")
class SetParameter(Action):
    """Sets a parameter of all later nodes (in this group); a node's own parameters override it."""

    def __init__(self, name: SomeSubstitutionsType, value: Any, **kwargs: Any) -> None:
        super().__init__(**kwargs)
        self.__parameters = normalize_parameter_dict({tuple(normalize_to_list_of_substitutions(name)): value})

    @classmethod
    def parse(cls, entity: Entity, parser: Parser) -> tuple[Any, dict[str, Any]]:
        _, keywords = super().parse(entity, parser)
        for name in ("name", "value"):
            keywords[name] = parser.parse_substitution(entity.get_attr(name))
        return cls, keywords

    @property
    def name(self) -> Any:
        return next(iter(self.__parameters))

    @property
    def value(self) -> Any:
        return self.__parameters[self.name]

    def execute(self, context: LaunchContext) -> Sequence[LaunchDescriptionEntity] | None:
        values = evaluate_parameter_dict(context, self.__parameters)
        # A new list, because the old one belongs to the surrounding group.
        before = context.launch_configurations.get("global_params", [])
        context.launch_configurations["global_params"] = [*before, *values.items()]
        return None
