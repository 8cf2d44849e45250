"""The handler for a process that says on its standard output that it is ready."""

from __future__ import annotations

from typing import Any

from launch.actions import ExecuteProcess
from launch.event_handlers import OnProcessIO
from launch.events.process import ProcessIO
from launch.launch_description_entity import LaunchDescriptionEntity


class StdoutReadyListener(OnProcessIO):
    """Visits `actions` when the process (None: any process) has printed `ready_txt`."""

    def __init__(
        self,
        *,
        target_action: ExecuteProcess | None = None,
        ready_txt: str,
        actions: list[LaunchDescriptionEntity],
    ) -> None:
        self.__actions = actions

        def visit_if_ready(event: ProcessIO) -> list[LaunchDescriptionEntity] | None:
            return actions if ready_txt in event.text.decode(errors="replace") else None

        super().__init__(target_action=target_action, on_stdout=visit_if_ready)

    def describe(self) -> tuple[str, list[Any]]:
        return super().describe()[0], self.__actions
