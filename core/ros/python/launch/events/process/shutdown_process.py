"""The order to a process to end."""

from __future__ import annotations

from launch.events.process.process_targeted_event import ProcessTargetedEvent


class ShutdownProcess(ProcessTargetedEvent):
    """SIGINT, and SIGTERM and SIGKILL if that does not help."""

    name = "launch.events.process.ShutdownProcess"
