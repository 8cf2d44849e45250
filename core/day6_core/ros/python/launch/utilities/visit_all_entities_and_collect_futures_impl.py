"""Visits an entity and all entities that follow from it."""

from __future__ import annotations

from typing import TYPE_CHECKING

from launch.launch_description_entity import LaunchDescriptionEntity

if TYPE_CHECKING:
    from launch._loop import Future
    from launch.launch_context import LaunchContext


def visit_all_entities_and_collect_futures(
    entity: LaunchDescriptionEntity, context: LaunchContext
) -> list[tuple[LaunchDescriptionEntity, Future]]:
    """Visit depth first; returns the entities that are not done after their visit, with their futures."""
    following = entity.visit(context)
    future = entity.get_asyncio_future()
    pairs = [] if future is None else [(entity, future)]
    for each in following or ():
        pairs += visit_all_entities_and_collect_futures(each, context)
    return pairs
