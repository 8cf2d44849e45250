"""Declares an argument of a launch file."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING, Any, List  # noqa: UP035

import launch.logging
from launch.action import Action
from launch.frontend.entity import Entity
from launch.frontend.expose import expose_action
from launch.launch_description_entity import LaunchDescriptionEntity
from launch.some_substitutions_type import SomeSubstitutionsType
from launch.substitution import Substitution
from launch.utilities import normalize_to_list_of_substitutions, perform_substitutions

if TYPE_CHECKING:
    from launch.frontend.parser import Parser
    from launch.launch_context import LaunchContext


@expose_action("arg")
class DeclareLaunchArgument(Action):
    """The argument `name`: unless it is given, the launch configuration of that name becomes `default_value`.

    Raises RuntimeError if it has no default and isn't given, or isn't one of `choices`.
    """

    def __init__(
        self,
        name: str,
        *,
        default_value: SomeSubstitutionsType | None = None,
        description: str | None = None,
        choices: Sequence[str] | None = None,
        **kwargs: Any,
    ) -> None:
        super().__init__(**kwargs)
        self.__name = name
        self.__default = None if default_value is None else normalize_to_list_of_substitutions(default_value)
        self.__choices = choices
        if choices is not None:
            if len(choices) == 0:
                self.__fail("Provided choices arg is empty. Use None to ignore the choice list.")
            if isinstance(default_value, str) and default_value not in choices:
                self.__fail(f'Provided default_value "{default_value}" is not in provided choices "{choices}".')
        self.__description = _description(description, choices)
        self._conditionally_included = False
        """Whether it depends on a condition; set by `LaunchDescription.get_launch_arguments`."""

    def __fail(self, text: str) -> None:
        launch.logging.get_logger(__name__).error(text)
        raise RuntimeError(text)

    @classmethod
    def parse(cls, entity: Entity, parser: Parser) -> tuple[Any, dict[str, Any]]:
        _, keywords = super().parse(entity, parser)
        keywords["name"] = parser.escape_characters(entity.get_attr("name"))
        default = entity.get_attr("default", optional=True)
        if default is not None:
            keywords["default_value"] = parser.parse_substitution(default)
        description = entity.get_attr("description", optional=True)
        if description is not None:
            keywords["description"] = parser.escape_characters(description)
        choices = entity.get_attr("choice", data_type=List[Entity], optional=True)  # noqa: UP006
        if choices is not None:
            keywords["choices"] = [parser.escape_characters(each.get_attr("value")) for each in choices]
        return cls, keywords

    @property
    def name(self) -> str:
        return self.__name

    @property
    def default_value(self) -> list[Substitution] | None:
        return self.__default

    @property
    def description(self) -> str:
        return self.__description

    @property
    def choices(self) -> Sequence[str] | None:
        return self.__choices

    def execute(self, context: LaunchContext) -> Sequence[LaunchDescriptionEntity] | None:
        if self.name not in context.launch_configurations:
            if self.__default is None:
                launch.logging.get_logger(__name__).error(
                    f'Required launch argument "{self.name}" (description: "{self.description}") was not provided'
                )
                raise RuntimeError(f'Required launch argument "{self.name}" was not provided.')
            context.launch_configurations[self.name] = perform_substitutions(context, self.__default)
        value = context.launch_configurations[self.name]
        if self.__choices is not None and value not in self.__choices:
            self.__fail(
                f'Argument "{self.name}" provided value "{value}" is not valid. Valid options are: {self.__choices}'
            )
        return None


def _description(given: str | None, choices: Sequence[str] | None) -> str:
    if given is None:
        return "no description given" if choices is None else f"One of: {choices}"
    if choices is None:
        return given
    return f"{given}{'' if given.endswith('.') else '.'} Valid choices are: {choices}"
