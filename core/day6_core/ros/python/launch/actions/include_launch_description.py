"""Includes another launch file."""

from __future__ import annotations

import os
from collections.abc import Iterable, Sequence
from typing import TYPE_CHECKING, Any, List  # noqa: UP035

import launch.logging
from launch.action import Action
from launch.actions.set_launch_configuration import SetLaunchConfiguration
from launch.frontend.entity import Entity
from launch.frontend.expose import expose_action
from launch.launch_context import LaunchContext
from launch.launch_description import LaunchDescription
from launch.launch_description_entity import LaunchDescriptionEntity
from launch.launch_description_source import LaunchDescriptionSource
from launch.launch_description_sources import AnyLaunchDescriptionSource
from launch.some_substitutions_type import SomeSubstitutionsType
from launch.utilities import normalize_to_list_of_substitutions, perform_substitutions

if TYPE_CHECKING:
    from launch.frontend.parser import Parser

_Arguments = Iterable[tuple[SomeSubstitutionsType, SomeSubstitutionsType]]


@expose_action("include")
class IncludeLaunchDescription(Action):
    """Visits the launch description of a source, or of the launch file at a path.

    `launch_arguments` become launch configurations. Raises RuntimeError if a declared argument without default is missing.
    """

    def __init__(
        self,
        launch_description_source: LaunchDescriptionSource | SomeSubstitutionsType,
        *,
        launch_arguments: _Arguments | None = None,
        **kwargs: Any,
    ) -> None:
        super().__init__(**kwargs)
        if not isinstance(launch_description_source, LaunchDescriptionSource):
            launch_description_source = AnyLaunchDescriptionSource(launch_description_source)
        self.__source = launch_description_source
        self.__arguments = tuple(launch_arguments or ())

    @classmethod
    def parse(cls, entity: Entity, parser: Parser) -> tuple[Any, dict[str, Any]]:
        _, keywords = super().parse(entity, parser)
        keywords["launch_description_source"] = parser.parse_substitution(entity.get_attr("file"))
        arguments = []
        for tag in ("let", "arg"):  # rolling writes `let`, jazzy `arg`
            found = entity.get_attr(tag, data_type=List[Entity], optional=True)  # noqa: UP006
            for each in found or ():
                pair = each.get_attr("name"), each.get_attr("value")
                arguments.append(tuple(parser.parse_substitution(text) for text in pair))
                each.assert_entity_completely_parsed()
        if arguments:
            keywords["launch_arguments"] = arguments
        return cls, keywords

    @property
    def launch_description_source(self) -> LaunchDescriptionSource:
        return self.__source

    @property
    def launch_arguments(self) -> Sequence[tuple[SomeSubstitutionsType, SomeSubstitutionsType]]:
        return self.__arguments

    def get_sub_entities(self) -> Sequence[LaunchDescriptionEntity]:
        description = self.__source.try_get_launch_description_without_context()
        return [] if description is None else [description]

    def _is_same_file(self, other: IncludeLaunchDescription) -> bool:
        """Return whether another include is of the same file, as far as that is known without launching."""
        return self.__source.described_location == other.__source.described_location

    def _argument_names(self, context: LaunchContext) -> list[str]:
        return [
            perform_substitutions(context, normalize_to_list_of_substitutions(name)) for name, _ in self.__arguments
        ]

    def _try_get_arguments_names_without_context(self) -> list[str] | None:
        try:
            return self._argument_names(LaunchContext())
        except Exception as error:
            # The names depend on the launch: they aren't known beforehand.
            launch.logging.get_logger(__name__).debug(
                f"Failed to get launch arguments names for launch description '{self.__source.location}', "
                f"with exception: {error}"
            )
        return None

    def execute(self, context: LaunchContext) -> Sequence[LaunchDescriptionEntity] | None:
        description = self.__source.get_launch_description(context)
        location = self.__source.location
        path = os.path.abspath(location)
        folder = os.path.dirname(path) if os.path.exists(path) else location  # "<script>" isn't in a folder
        context.extend_locals({"current_launch_file_path": path, "current_launch_file_directory": folder})
        self.__check_arguments(description, self._argument_names(context))
        return [*(SetLaunchConfiguration(name, value) for name, value in self.__arguments), description]

    def __check_arguments(self, description: LaunchDescription, given: list[str]) -> None:
        for argument, includes in description.get_launch_arguments_with_include_launch_description_actions():
            if argument._conditionally_included or argument.default_value is not None:
                continue
            names = list(given)
            for include in includes or ():
                names += include._try_get_arguments_names_without_context() or []
            if argument.name not in names:
                raise RuntimeError(
                    f"Included launch description missing required argument '{argument.name}' "
                    f"(description: '{argument.description}'), given: [{', '.join(names)}]"
                )
