"""The base of the actions that run a test as a process."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING, Any

from launch.actions import ExecuteProcess, OpaqueFunction, TimerAction
from launch.event_handlers import OnProcessExit
from launch.launch_description_entity import LaunchDescriptionEntity
from launch.some_substitutions_type import SomeSubstitutionsType

if TYPE_CHECKING:
    from launch.launch_context import LaunchContext


class Test(ExecuteProcess):
    """Runs a test, which is interrupted after `timeout` seconds and killed `kill_timeout` seconds later."""

    __test__ = False  # no class that pytest collects

    def __init__(
        self,
        *,
        timeout: float | SomeSubstitutionsType | None = None,
        kill_timeout: float | SomeSubstitutionsType = 5.0,
        **kwargs: Any,
    ) -> None:
        super().__init__(**kwargs)
        self.__timeout = timeout

    @property
    def timeout(self) -> Any:
        return self.__timeout

    def execute(self, context: LaunchContext) -> Sequence[LaunchDescriptionEntity] | None:
        actions = super().execute(context)
        if not self.__timeout:
            return actions
        stop = OpaqueFunction(function=self._shutdown_process, kwargs={"send_sigint": True})
        timer = TimerAction(period=self.__timeout, actions=[stop])
        context.register_event_handler(OnProcessExit(target_action=self, on_exit=lambda event, context: timer.cancel()))
        return [*(actions or ()), timer]
