"""How long an executor waits, and the exceptions that end a wait."""

from __future__ import annotations

from collections.abc import Callable

from rclpy.constants import S_TO_NS

NEVER_TRUE: Callable[[], bool] = bool

FOREVER = -1


class TimeoutException(Exception):
    """Nothing became ready in time."""

    __module__ = "rclpy.executors"


class ShutdownException(Exception):
    """The executor was shut down."""

    __module__ = "rclpy.executors"


class ExternalShutdownException(Exception):
    """The context was shut down from outside, for instance by a signal."""

    __module__ = "rclpy.executors"


class ConditionReachedException(Exception):
    """The condition of the wait became true."""

    __module__ = "rclpy.executors"


class TimeoutObject:
    """A timeout that can be changed during the wait."""

    def __init__(self, timeout: float) -> None:
        self._timeout = timeout

    @property
    def timeout(self) -> float:
        """The timeout in seconds."""
        return self._timeout

    @timeout.setter
    def timeout(self, timeout: float) -> None:
        self._timeout = timeout


def nanoseconds(timeout_sec: float | TimeoutObject | None) -> int:
    """Return a timeout in nanoseconds, -1 for ever."""
    if timeout_sec is None:
        return FOREVER
    if isinstance(timeout_sec, TimeoutObject):
        timeout_sec = timeout_sec.timeout
    return FOREVER if timeout_sec < 0 else int(float(timeout_sec) * S_TO_NS)
