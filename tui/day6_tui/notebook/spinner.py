"""One node of a cell, spun by a thread of its own: until the node is gone, ROS is shut down, or a callback fails.

A thread for each, so that a callback that does not return holds up its own node only. What callbacks print lands in the cell that
made the node, or last gave it something to do.
"""

from __future__ import annotations

import ctypes
import sys
import threading
import time
from collections.abc import Callable
from contextvars import Context as Variables
from contextvars import copy_context
from types import FrameType
from typing import TYPE_CHECKING, Any, TypeVar

from day6_core.session.cores import join
from rclpy.executors import ExternalShutdownException, SingleThreadedExecutor

if TYPE_CHECKING:
    from rclpy.context import Context
    from rclpy.node import Node
    from rclpy.task import Task

Item = TypeVar("Item")
Result = TypeVar("Result")

END_SECONDS = 1.0
"""What a running callback gets to return when its node ends."""


class _Ended(SystemExit):
    """Raised in a callback that does not return although its node has ended; no thread tells of a SystemExit."""


class _CellExecutor(SingleThreadedExecutor):
    """Runs callbacks among the variables of a cell, by which ipykernel 7 knows where output belongs; notes when one began."""

    def __init__(self, context: Context) -> None:
        super().__init__(context=context)
        self.cell = copy_context()
        self.busy_since: float | None = None

    def _execute(self, entity: Any) -> bool:
        return self._watched(super()._execute, entity)

    def _run_task(self, task: Task[Any]) -> None:
        self._watched(super()._run_task, task)

    def _watched(self, run: Callable[[Item], Result], item: Item) -> Result:
        if self.busy_since is not None:  # a coroutine, which begins within its entity
            return run(item)
        self.busy_since = time.monotonic()
        try:
            return self.cell.run(run, item)
        finally:
            self.busy_since = None


class Spinner:
    """Spins a node; `fail` is called on the thread with what a callback has raised, after which nothing is spun here."""

    def __init__(self, node: Node, fail: Callable[[Spinner, BaseException], None]) -> None:
        self.node = node
        self.name: str = node.get_fully_qualified_name()
        self.has_failed = False
        self.is_called_stuck = False
        self._fail = fail
        self._is_ended = False
        self._tasks = 0
        self._executor = _CellExecutor(node.context)
        # ipykernel 6 knows by the cell in which a thread was started where output belongs.
        self._thread = threading.Thread(target=self._spin, name=f"day6 {self.name}", daemon=True)
        self.take()
        self._thread.start()

    @property
    def cell(self) -> Variables:
        """A copy of the variables of the cell where output belongs."""
        return self._executor.cell.copy()

    def take(self) -> None:
        """At the end of a cell: spin the node, if the cell has spun it; its output belongs to a cell that gave it work."""
        node = self.node
        tasks = sum(1 for each in (node.timers, node.subscriptions, node.services, node.clients) for _ in each)
        if tasks > self._tasks:
            self._executor.cell = copy_context()
        self._tasks = tasks
        if not self.has_failed and not _is_spun(node):
            self._executor.add_node(node)

    def busy_seconds(self) -> float:
        """Return how long the callback has been running that runs now; 0 if there is none."""
        since = self._executor.busy_since
        return 0.0 if since is None else time.monotonic() - since

    def frame(self) -> FrameType | None:
        """Return where the thread is."""
        return sys._current_frames().get(self._thread.ident or 0)

    def end(self) -> None:
        """Spin no more, and end a callback that runs on. The node stays."""
        self._is_ended = True
        self._executor.shutdown()
        if self._thread is threading.current_thread():
            return
        join(self._thread, END_SECONDS)
        if self._thread.is_alive():
            kind = ctypes.py_object(_Ended)
            ctypes.pythonapi.PyThreadState_SetAsyncExc(ctypes.c_ulong(self._thread.ident or 0), kind)

    def _is_over(self) -> bool:
        return self._is_ended or not self._executor.context.ok()

    def _spin(self) -> None:
        try:
            while not self._is_over():
                self._executor.spin_once()
        except (ExternalShutdownException, _Ended):
            return
        except (Exception, SystemExit, KeyboardInterrupt) as error:  # whatever a callback raises ends its node only
            if not self._is_over():
                self.has_failed = True
                self._executor.shutdown()
                self._executor.cell.run(self._fail, self, error)


def _is_spun(node: Node) -> bool:
    """Whether an executor has the node, this one or one of the cells."""
    return node.executor is not None and node in node.executor.get_nodes()
