"""Restores the environment."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING

from launch.action import Action
from launch.launch_description_entity import LaunchDescriptionEntity

if TYPE_CHECKING:
    from launch.launch_context import LaunchContext


class PopEnvironment(Action):
    """Restores the environment of the last `PushEnvironment`."""

    def execute(self, context: LaunchContext) -> Sequence[LaunchDescriptionEntity] | None:
        context._pop_environment()
        return None
