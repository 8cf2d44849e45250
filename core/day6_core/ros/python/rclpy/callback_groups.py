"""Callback groups: which callbacks may run at the same time."""

from __future__ import annotations

import weakref
from collections import deque
from threading import Lock
from typing import TYPE_CHECKING, Any

from rclpy._day6.incidental import also

if TYPE_CHECKING:
    from rclpy._day6.entity import Entity


__getattr__ = also(__name__)


class CallbackGroup:
    """Base of the callback groups: decides when an entity's callback may run."""

    def __init__(self) -> None:
        self.entities: set[weakref.ReferenceType[Any]] = set()
        self._deferred: deque[Entity] = deque()
        """Entities that were ready while they might not run; executors put them here and take them out again."""

    def add_entity(self, entity: Entity) -> None:
        """Add an entity to the group."""
        self.entities.add(weakref.ref(entity))

    def has_entity(self, entity: Entity) -> bool:
        """Return whether an entity belongs to the group."""
        return weakref.ref(entity) in self.entities

    def can_execute(self, entity: Entity) -> bool:
        """Return whether the entity's callback may run now."""
        raise NotImplementedError

    def beginning_execution(self, entity: Entity) -> bool:
        """Reserve the group for the entity's callback; False if it may not run now."""
        raise NotImplementedError

    def ending_execution(self, entity: Entity) -> None:
        """Release what `beginning_execution` reserved."""
        raise NotImplementedError


class ReentrantCallbackGroup(CallbackGroup):
    """Lets all its callbacks run at the same time."""

    def can_execute(self, entity: Entity) -> bool:
        """Return True."""
        return True

    def beginning_execution(self, entity: Entity) -> bool:
        """Return True."""
        return True

    def ending_execution(self, entity: Entity) -> None:
        """Do nothing."""


class MutuallyExclusiveCallbackGroup(CallbackGroup):
    """Lets one of its callbacks run at a time."""

    def __init__(self) -> None:
        super().__init__()
        self._active_entity: Entity | None = None
        self._lock = Lock()

    def can_execute(self, entity: Entity) -> bool:
        """Return whether no callback of the group is running."""
        return self._active_entity is None

    def beginning_execution(self, entity: Entity) -> bool:
        """Reserve the group for the entity's callback; False if another one is running."""
        with self._lock:
            if self._active_entity is None:
                self._active_entity = entity
                return True
        return False

    def ending_execution(self, entity: Entity) -> None:
        """Let the next one run."""
        assert self._active_entity == entity
        self._active_entity = None
