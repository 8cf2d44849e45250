"""The event that shuts a process down."""

from __future__ import annotations

from launch.events.process.process_targeted_event import ProcessTargetedEvent


class ShutdownProcess(ProcessTargetedEvent):
    """Sends SIGINT, then SIGTERM and SIGKILL if that does not help."""

    name = "launch.events.process.ShutdownProcess"
