"""Resets the environment."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING, Any

from launch.action import Action
from launch.frontend.expose import expose_action
from launch.launch_description_entity import LaunchDescriptionEntity

if TYPE_CHECKING:
    from launch.frontend.entity import Entity
    from launch.frontend.parser import Parser
    from launch.launch_context import LaunchContext


@expose_action("reset_env")
class ResetEnvironment(Action):
    """Restores the environment that the launch began with."""

    @classmethod
    def parse(cls, entity: Entity, parser: Parser) -> tuple[Any, dict[str, Any]]:
        return cls, super().parse(entity, parser)[1]

    def execute(self, context: LaunchContext) -> Sequence[LaunchDescriptionEntity] | None:
        context._reset_environment()
        return None
