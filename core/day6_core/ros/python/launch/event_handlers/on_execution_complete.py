"""The handler for the end of an action."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

from launch.event_handlers.on_action_event_base import OnActionEventBase
from launch.events.execution_complete import ExecutionComplete
from launch.some_entities_type import SomeEntitiesType


class OnExecutionComplete(OnActionEventBase):
    """Visit `on_completion`, or what it returns for `(event, context)`, when an action is done."""

    def __init__(
        self,
        *,
        target_action: Any = None,
        on_completion: SomeEntitiesType | Callable[..., SomeEntitiesType | None],
        **kwargs: Any,
    ) -> None:
        from launch.action import Action

        super().__init__(
            action_matcher=target_action,
            on_event=on_completion,
            target_event_cls=ExecutionComplete,
            target_action_cls=Action,
            **kwargs,
        )
