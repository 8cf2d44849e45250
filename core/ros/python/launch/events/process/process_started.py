"""The event that a process runs."""

from __future__ import annotations

from launch.events.process.running_process_event import RunningProcessEvent


class ProcessStarted(RunningProcessEvent):
    """A process runs; `pid` is its number."""

    name = "launch.events.process.ProcessStarted"
