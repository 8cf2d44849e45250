"""The events executor. Our SingleThreadedExecutor is driven by events anyway, so this is one."""

from __future__ import annotations

from rclpy.context import Context
from rclpy.executors import Executor, SingleThreadedExecutor


class _EventsExecutor(SingleThreadedExecutor):
    """A single-threaded executor driven by events."""


def EventsExecutor(*, context: Context | None = None) -> Executor:
    """Make an executor that runs callbacks in the order in which things happen, in the thread that spins."""
    return _EventsExecutor(context=context)
