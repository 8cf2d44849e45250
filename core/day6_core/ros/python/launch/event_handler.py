"""Event handlers: the entities to visit when a certain kind of event occurs."""

from __future__ import annotations

from collections.abc import Callable
from typing import TYPE_CHECKING, Any

from launch.event import Event
from launch.some_entities_type import SomeEntitiesType

if TYPE_CHECKING:
    from launch.launch_context import LaunchContext


class BaseEventHandler:
    """Base of all handlers: handles the events for which `matcher(event)` is true; with `handle_once` only the first."""

    def __init__(self, *, matcher: Callable[[Any], bool], handle_once: bool = False) -> None:
        self.__matcher = matcher
        self.__handle_once = handle_once

    @property
    def handle_once(self) -> bool:
        return self.__handle_once

    @property
    def handler_description(self) -> str | None:
        return None

    @property
    def matcher_description(self) -> str | None:
        return None

    def matches(self, event: Event) -> bool:
        return self.__matcher(event)

    def describe(self) -> tuple[str, list[Any]]:
        """Return a line for `ros2 launch --print`, and the entities below it."""
        kind, matcher, handler = type(self).__name__, self.matcher_description, self.handler_description
        return f"{kind}(matcher='{matcher}', handler='{handler}', handle_once={self.handle_once})", []

    def handle(self, event: Event, context: LaunchContext) -> SomeEntitiesType | None:
        """Handle an event and return entities, which see it as `context.locals.event`."""
        context.extend_locals({"event": event})
        if self.handle_once:
            context.unregister_event_handler(self)
        return None


class EventHandler(BaseEventHandler):
    """A handler that returns the same entities for every event."""

    def __init__(
        self, *, matcher: Callable[[Any], bool], entities: SomeEntitiesType | None = None, handle_once: bool = False
    ) -> None:
        super().__init__(matcher=matcher, handle_once=handle_once)
        self.__entities = entities

    @property
    def entities(self) -> SomeEntitiesType | None:
        return self.__entities

    def describe(self) -> tuple[str, list[Any]]:
        from launch.launch_description_entity import LaunchDescriptionEntity

        text, actions = super().describe()
        if isinstance(self.entities, LaunchDescriptionEntity):
            actions.append(self.entities)
        elif self.entities is not None:
            actions.extend(self.entities)
        return text, actions

    def handle(self, event: Event, context: LaunchContext) -> SomeEntitiesType | None:
        super().handle(event, context)
        return self.entities
