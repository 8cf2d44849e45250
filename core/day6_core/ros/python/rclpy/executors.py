"""Executors: they run the callbacks of nodes."""

from __future__ import annotations

import os
import warnings
from collections import deque
from collections.abc import Awaitable, Callable
from typing import Any, TypeVar, overload

from rclpy._day6.callables import is_coroutine_function
from rclpy._day6.entity import Entity
from rclpy._day6.executor import Executor as Executor
from rclpy._day6.executor_timeouts import FOREVER, NEVER_TRUE, nanoseconds
from rclpy._day6.executor_timeouts import ConditionReachedException as ConditionReachedException
from rclpy._day6.executor_timeouts import ExternalShutdownException as ExternalShutdownException
from rclpy._day6.executor_timeouts import ShutdownException as ShutdownException
from rclpy._day6.executor_timeouts import TimeoutException as TimeoutException
from rclpy._day6.executor_timeouts import TimeoutObject as TimeoutObject
from rclpy._day6.incidental import also
from rclpy._day6.withdrawn import withdraw
from rclpy.client import Client
from rclpy.context import Context
from rclpy.task import Future, Task

__getattr__ = also(
    __name__,
    "Msg Clock ClockType GuardCondition InvalidHandle MessageInfo NumberOfEntities Service "
    "SignalHandlerGuardCondition Subscription Timer TimerCancelledError TimerInfo Waitable "
    "get_default_context timeout_sec_to_nsec",
)


T = TypeVar("T")


@overload
async def await_or_execute(callback: Callable[..., Awaitable[T]], *args: object) -> T: ...


@overload
async def await_or_execute(callback: Callable[..., T], *args: object) -> T: ...


async def await_or_execute(callback: Callable[..., Any], *args: object) -> Any:
    """Call a function, awaiting it if it is a coroutine function."""
    if is_coroutine_function(callback):
        return await callback(*args)
    return callback(*args)


class SingleThreadedExecutor(Executor):
    """Runs callbacks in the thread that spins."""

    def _spin_once_impl(
        self, timeout_sec: float | TimeoutObject | None = None, wait_condition: Callable[[], bool] = NEVER_TRUE
    ) -> None:
        timeout_ns = FOREVER if timeout_sec is None else nanoseconds(timeout_sec)
        spin_arguments = (timeout_sec, wait_condition)
        until: int | None = None
        while True:
            item = self._next(timeout_ns, wait_condition, spin_arguments)
            if item is None:
                return
            if item.__class__ is Task:
                self._run_task(item)
                return
            if self._execute(item):  # type: ignore[arg-type]
                return
            # A false alarm doesn't count: go on with the time that is left.
            if timeout_ns > 0:
                now = self._steady_ns()
                until = now + timeout_ns if until is None else until
                timeout_ns = max(0, until - now)

    def spin_once(self, timeout_sec: float | None = None) -> None:
        """Run one callback, or wait for one until `timeout_sec` (None or negative: for ever, 0: not at all)."""
        with self._spinning:
            self._spin_once_impl(timeout_sec)

    def _spin_once_until_future_complete(
        self, future: Future[Any], timeout_sec: float | TimeoutObject | None = None
    ) -> None:
        self._spin_once_impl(timeout_sec, future.done)


class MultiThreadedExecutor(Executor):
    """Runs callbacks in a pool of threads.

    `num_threads` is by default the number of processors this process may use.

    Raises:
        ValueError: for less than one.
    """

    def __init__(self, num_threads: int | None = None, *, context: Context | None = None) -> None:
        super().__init__(context=context)
        from concurrent.futures import ThreadPoolExecutor

        if num_threads is None:
            affinity = getattr(os, "sched_getaffinity", None)
            num_threads = (len(affinity(0)) if affinity is not None else os.cpu_count()) or 2
        if num_threads == 1:
            warnings.warn(
                "MultiThreadedExecutor is used with a single thread.\nUse the SingleThreadedExecutor instead.",
                stacklevel=1,
            )
        self._failed: deque[Future[Any]] = deque()
        """Futures with exceptions of callbacks that have not been raised yet."""
        self._executor = ThreadPoolExecutor(num_threads)

    def _work_on(self, item: Entity | Task[Any]) -> None:
        try:
            if isinstance(item, Task):
                self._run_task(item)
            else:
                self._execute(item)
        except Exception as error:
            failed: Future[Any] = Future()
            failed.set_exception(error)
            self._failed.append(failed)
        except BaseException as error:
            # Others, such as SystemExit, are lost in the pool, as in real rclpy.
            from rclpy._day6.lost_errors import remember

            remember(error)
            raise

    def _spin_once_impl(
        self, timeout_sec: float | TimeoutObject | None = None, wait_condition: Callable[[], bool] = NEVER_TRUE
    ) -> None:
        try:
            item = self._next(nanoseconds(timeout_sec), wait_condition, (timeout_sec, wait_condition))
        except ExternalShutdownException:
            return
        if item is None:
            return
        if isinstance(item, Client):
            # Only sets a future; a thread for that would cost more than the work.
            self._work_on(item)
        else:
            self._executor.submit(self._work_on, item)
        if self._failed:
            self._failed.popleft().result()

    def spin_once(self, timeout_sec: float | None = None) -> None:
        """Hand one callback to a thread, or wait for one until `timeout_sec`.

        Then raises the exception of an earlier callback: as in real rclpy it stays hidden until the next callback is due.
        """
        with self._spinning:
            self._spin_once_impl(timeout_sec)

    def _spin_once_until_future_complete(
        self, future: Future[Any], timeout_sec: float | TimeoutObject | None = None
    ) -> None:
        self._spin_once_impl(timeout_sec, future.done)

    def shutdown(self, timeout_sec: float | None = None, *, wait_for_threads: bool = True) -> bool:
        """Stop running callbacks; by default wait for the threads, for which `timeout_sec` is no limit, as in real rclpy."""
        success = super().shutdown(timeout_sec)
        self._executor.shutdown(wait=wait_for_threads)
        return success


withdraw(__name__)
