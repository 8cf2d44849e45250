"""The handler for a process's output."""

from __future__ import annotations

from collections.abc import Callable
from typing import TYPE_CHECKING, Any

from launch.event_handlers.on_action_event_base import OnActionEventBase
from launch.events.process.process_io import ProcessIO
from launch.some_entities_type import SomeEntitiesType

if TYPE_CHECKING:
    from launch.launch_context import LaunchContext

_Function = Callable[[ProcessIO], "SomeEntitiesType | None"]


class OnProcessIO(OnActionEventBase):
    """Call `on_stdout(event)` or `on_stderr(event)` when a process has written, and visit the entities it returns."""

    def __init__(
        self,
        *,
        target_action: Any = None,
        on_stdin: _Function | None = None,
        on_stdout: _Function | None = None,
        on_stderr: _Function | None = None,
        **kwargs: Any,
    ) -> None:
        from launch.actions.execute_local import ExecuteLocal

        def handle(event: ProcessIO, context: LaunchContext) -> SomeEntitiesType | None:
            function = on_stdout if event.from_stdout else on_stderr if event.from_stderr else on_stdin
            return None if function is None else function(event)

        super().__init__(
            action_matcher=target_action,
            on_event=handle,
            target_event_cls=ProcessIO,
            target_action_cls=ExecuteLocal,
            **kwargs,
        )
