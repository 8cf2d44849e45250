"""The handler for the end of a launch."""

from __future__ import annotations

from collections.abc import Callable
from typing import TYPE_CHECKING, Any

from launch.event import Event
from launch.event_handler import BaseEventHandler
from launch.events.shutdown import Shutdown
from launch.some_entities_type import SomeEntitiesType
from launch.utilities.class_tools_impl import is_a_subclass

if TYPE_CHECKING:
    from launch.launch_context import LaunchContext


class OnShutdown(BaseEventHandler):
    """Visit `on_shutdown`, or what it returns for `(event, context)`, when the launch ends."""

    def __init__(
        self, *, on_shutdown: SomeEntitiesType | Callable[..., SomeEntitiesType | None], **kwargs: Any
    ) -> None:
        super().__init__(matcher=lambda event: is_a_subclass(event, Shutdown), **kwargs)
        self.__on_shutdown = on_shutdown

    def handle(self, event: Event, context: LaunchContext) -> SomeEntitiesType | None:
        super().handle(event, context)
        return self.__on_shutdown(event, context) if callable(self.__on_shutdown) else self.__on_shutdown

    @property
    def handler_description(self) -> str:
        return str(self.__on_shutdown)

    @property
    def matcher_description(self) -> str:
        return "event issubclass of launch.events.Shutdown"
