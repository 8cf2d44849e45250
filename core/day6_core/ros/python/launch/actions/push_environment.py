"""Saves the environment."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING

from launch.action import Action
from launch.launch_description_entity import LaunchDescriptionEntity

if TYPE_CHECKING:
    from launch.launch_context import LaunchContext


class PushEnvironment(Action):
    """Saves the environment for `PopEnvironment`."""

    def execute(self, context: LaunchContext) -> Sequence[LaunchDescriptionEntity] | None:
        context._push_environment()
        return None
