"""The event that a process has started."""

from __future__ import annotations

from launch.events.process.running_process_event import RunningProcessEvent


class ProcessStarted(RunningProcessEvent):
    """A process has started; `pid` is its number."""

    name = "launch.events.process.ProcessStarted"
