"""Flattens entities and lists of entities."""

from __future__ import annotations

from collections.abc import Iterable

from launch.launch_description_entity import LaunchDescriptionEntity
from launch.some_entities_type import SomeEntitiesType


def normalize_to_list_of_entities(entities: Iterable[SomeEntitiesType]) -> list[LaunchDescriptionEntity]:
    """Return all entities, including those in lists, as one list."""
    flat: list[LaunchDescriptionEntity] = []
    for each in entities:
        if isinstance(each, LaunchDescriptionEntity):
            flat.append(each)
        else:
            flat.extend(each)
    return flat
