"""Entities, the elements of launch descriptions."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from launch._loop import Future
    from launch.launch_context import LaunchContext


class LaunchDescriptionEntity:
    """Base of launch descriptions and actions. Launching visits an entity, then those that its visit returns."""

    def describe(self) -> str:
        """Return the text that `ros2 launch --print` shows."""
        raise NotImplementedError(f"{type(self).__name__} has no description")

    def describe_sub_entities(self) -> Sequence[LaunchDescriptionEntity]:
        """Return the entities that a visit always returns."""
        return []

    def describe_conditional_sub_entities(self) -> Sequence[tuple[str, Iterable[LaunchDescriptionEntity]]]:
        """Return `(condition, entities)` for those that it returns under a condition."""
        return []

    def visit(self, context: LaunchContext) -> Sequence[LaunchDescriptionEntity] | None:
        """Execute the entity; returns the entities to visit next."""
        return None

    def get_asyncio_future(self) -> Future | None:
        """Return a future that is done when the entity is, None if it is done with its visit."""
        return None
