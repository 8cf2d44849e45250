"""Launch descriptions, the return values of `generate_launch_description()`."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from typing import TYPE_CHECKING, Any

import launch.logging
from launch.action import Action
from launch.launch_description_entity import LaunchDescriptionEntity

if TYPE_CHECKING:
    from launch.actions.declare_launch_argument import DeclareLaunchArgument
    from launch.launch_context import LaunchContext

_Found = list[tuple["DeclareLaunchArgument", "list[Any] | None"]]


class LaunchDescription(LaunchDescriptionEntity):
    """Entities, usually actions, that are visited in this order."""

    def __init__(
        self,
        initial_entities: Iterable[LaunchDescriptionEntity] | None = None,
        *,
        deprecated_reason: str | None = None,
    ) -> None:
        self.__entities = list(initial_entities) if initial_entities is not None else []
        self.__deprecated_reason = deprecated_reason

    @property
    def entities(self) -> list[LaunchDescriptionEntity]:
        return self.__entities

    @property
    def deprecated(self) -> bool:
        return self.__deprecated_reason is not None

    @property
    def deprecated_reason(self) -> str | None:
        return self.__deprecated_reason

    def add_entity(self, entity: LaunchDescriptionEntity) -> None:
        self.__entities.append(entity)

    def add_action(self, action: Action) -> None:
        self.add_entity(action)

    def visit(self, context: LaunchContext) -> Sequence[LaunchDescriptionEntity] | None:
        if self.__deprecated_reason is not None:
            path = context.get_locals_as_dict().get("current_launch_file_path")
            what = "deprecated launch description" if path is None else f"launch file [{path}] is deprecated"
            launch.logging.get_logger().warning(f"{what}: {self.__deprecated_reason}")
        return self.__entities

    def describe_sub_entities(self) -> Sequence[LaunchDescriptionEntity]:
        return self.__entities

    def get_launch_arguments(self, conditional_inclusion: bool = False) -> list[DeclareLaunchArgument]:
        """Return the arguments declared here and in included files, as far as they are known without launching."""
        return [
            argument
            for argument, _ in self.get_launch_arguments_with_include_launch_description_actions(conditional_inclusion)
        ]

    def get_launch_arguments_with_include_launch_description_actions(
        self, conditional_inclusion: bool = False
    ) -> _Found:
        """Return the arguments, the first of each name, each with the includes that lead to it (None: declared here)."""
        found: _Found = []
        _collect(self.entities, conditional_inclusion, None, found)
        return found


def _collect(
    entities: Iterable[LaunchDescriptionEntity], conditional: bool, includes: list[Any] | None, found: _Found
) -> None:
    from launch.actions.declare_launch_argument import DeclareLaunchArgument
    from launch.actions.include_launch_description import IncludeLaunchDescription
    from launch.actions.reset_launch_configurations import ResetLaunchConfigurations

    for entity in entities:
        if isinstance(entity, ResetLaunchConfigurations):
            return  # later arguments can't be given from outside
        if isinstance(entity, DeclareLaunchArgument):
            if all(entity.name != argument.name for argument, _ in found):
                entity._conditionally_included = conditional or entity.condition is not None
                found.append((entity, includes))
            continue
        through = includes
        if isinstance(entity, IncludeLaunchDescription):
            if any(entity._is_same_file(include) for include in includes or ()):
                continue  # a file that includes itself declares nothing new, and would be read for ever
            through = [*(includes or []), entity]
        _collect(entity.describe_sub_entities(), False, through, found)
        for _, conditional_entities in entity.describe_conditional_sub_entities():
            _collect(conditional_entities, True, through, found)
