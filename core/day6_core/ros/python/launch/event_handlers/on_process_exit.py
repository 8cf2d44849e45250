"""The handler for the end of a process."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

from launch.event_handlers.on_action_event_base import OnActionEventBase
from launch.events.process.process_exited import ProcessExited
from launch.some_entities_type import SomeEntitiesType


class OnProcessExit(OnActionEventBase):
    """Visit `on_exit`, or what it returns for `(event, context)`, when a process has ended."""

    def __init__(
        self,
        *,
        target_action: Any = None,
        on_exit: SomeEntitiesType | Callable[..., SomeEntitiesType | None],
        **kwargs: Any,
    ) -> None:
        from launch.actions.execute_local import ExecuteLocal

        super().__init__(
            action_matcher=target_action,
            on_event=on_exit,
            target_event_cls=ProcessExited,
            target_action_cls=ExecuteLocal,
            **kwargs,
        )
