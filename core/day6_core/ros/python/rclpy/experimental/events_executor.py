"""The events executor. All executors here are driven by events; this one ignores callback groups."""

from __future__ import annotations

from typing import Any

from rclpy._day6.entity import Entity
from rclpy._day6.executor_timeouts import TimeoutObject
from rclpy.constants import S_TO_NS
from rclpy.context import Context
from rclpy.executors import Executor, SingleThreadedExecutor
from rclpy.task import Future


class _EventsExecutor(SingleThreadedExecutor):
    """Runs callbacks in the thread that spins, without regard to callback groups, as rclpy's experimental executor does.

    A waiting coroutine therefore doesn't hold up its group. After its timeout `spin_until_future_complete` still runs the
    callbacks that are ready.
    """

    def _begin(self, entity: Entity) -> bool:
        return True

    def _end(self, entity: Entity) -> None:
        """Do nothing: no callback group was reserved."""

    def spin_until_future_complete(self, future: Future[Any], timeout_sec: float | None = None) -> None:
        """Run callbacks until `future` is done, or `timeout_sec` is over and nothing is ready any more."""
        end = None if timeout_sec is None or timeout_sec < 0 else self._steady_ns() + int(timeout_sec * S_TO_NS)
        self._wake_when_done(future)
        left = TimeoutObject(-1.0)
        with self._spinning:
            while self._context._valid and not future.done() and not future.cancelled() and not self._is_shutdown:
                if self._run_ready():
                    continue
                if end is not None:
                    now = self._steady_ns()
                    if now >= end:
                        return
                    left.timeout = (end - now) / S_TO_NS
                self._spin_once_until_future_complete(future, left)


def EventsExecutor(*, context: Context | None = None) -> Executor:
    """Return an executor that is driven by events and ignores callback groups."""
    return _EventsExecutor(context=context)
