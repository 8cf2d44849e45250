"""The handler that visits an included launch description."""

from __future__ import annotations

from typing import Any

from launch.event_handler import EventHandler
from launch.events.include_launch_description import IncludeLaunchDescription
from launch.utilities.class_tools_impl import is_a_subclass


class OnIncludeLaunchDescription(EventHandler):
    """Visits the launch description of the event. Every launch has this handler from the start."""

    def __init__(self, **kwargs: Any) -> None:
        from launch.actions.opaque_function import OpaqueFunction

        super().__init__(
            matcher=lambda event: is_a_subclass(event, IncludeLaunchDescription),
            entities=OpaqueFunction(function=lambda context: [context.locals.event.launch_description]),
            **kwargs,
        )

    @property
    def handler_description(self) -> str:
        return "returns the launch_description in the event"

    @property
    def matcher_description(self) -> str:
        return "event issubclass of launch.events.IncludeLaunchDescription"
