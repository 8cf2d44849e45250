"""What a launch description consists of."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from launch._loop import Future
    from launch.launch_context import LaunchContext


class LaunchDescriptionEntity:
    """Base of launch descriptions and actions. Launching visits an entity, then those that its visit returned."""

    def describe(self) -> str:
        """Return what `ros2 launch --print` shows."""
        return self.__repr__()

    def describe_sub_entities(self) -> Sequence[LaunchDescriptionEntity]:
        """Return the entities that a visit will return for certain."""
        return []

    def describe_conditional_sub_entities(self) -> Sequence[tuple[str, Iterable[LaunchDescriptionEntity]]]:
        """Return `(condition, entities)` for those that it may return."""
        return []

    def visit(self, context: LaunchContext) -> Sequence[LaunchDescriptionEntity] | None:
        """Do what the entity stands for; return what is to be visited next."""
        return None

    def get_asyncio_future(self) -> Future | None:
        """Return a future that is done when the entity is, None if its visit was all."""
        return None
