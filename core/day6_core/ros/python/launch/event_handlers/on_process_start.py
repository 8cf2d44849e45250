"""The handler for the start of a process."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

from launch.event_handlers.on_action_event_base import OnActionEventBase
from launch.events.process.process_started import ProcessStarted
from launch.some_entities_type import SomeEntitiesType


class OnProcessStart(OnActionEventBase):
    """Visit `on_start`, or what it returns for `(event, context)`, when a process has started."""

    def __init__(
        self,
        *,
        target_action: Any = None,
        on_start: SomeEntitiesType | Callable[..., SomeEntitiesType | None],
        **kwargs: Any,
    ) -> None:
        from launch.actions.execute_process import ExecuteProcess

        super().__init__(
            action_matcher=target_action,
            on_event=on_start,
            target_event_cls=ProcessStarted,
            target_action_cls=ExecuteProcess,
            **kwargs,
        )
