"""Futures, and tasks that executors run."""

from __future__ import annotations

import sys
import threading
import warnings
import weakref
from collections.abc import Callable, Coroutine, Generator
from enum import Enum
from typing import TYPE_CHECKING, Any, Generic, TypeVar

from rclpy._day6.callables import is_coroutine_function
from rclpy._day6.incidental import also

if TYPE_CHECKING:
    from rclpy.executors import Executor

__getattr__ = also(__name__)

T = TypeVar("T")

_running = threading.local()
"""`task` is the task whose coroutine is running on this thread."""


class FutureState(Enum):
    """The states of a future."""

    PENDING = "PENDING"
    CANCELLED = "CANCELLED"
    FINISHED = "FINISHED"


_PENDING = FutureState.PENDING
_FINISHED = FutureState.FINISHED
_CANCELLED = FutureState.CANCELLED


def _no_executor() -> None:
    """Stand for the weak reference of a future that has no executor."""


class Future(Generic[T]):
    """A result that is not available yet. It can be awaited in coroutines that an executor runs."""

    def __init__(self, *, executor: Executor | None = None) -> None:
        self._state = _PENDING
        self._result: T | None = None
        self._exception: Exception | None = None
        self._exception_fetched = False
        self._callbacks: list[Callable[[Future[T]], object]] = []
        self._watchers: list[Callable[[], None]] = []
        """Called at once, on the thread that completes the future: executors and tasks that wait for it."""
        self._lock = threading.Lock()
        self._executor: Callable[[], Executor | None] = _no_executor if executor is None else weakref.ref(executor)

    def __del__(self) -> None:
        if self._exception is not None and not self._exception_fetched:
            print(f"The following exception was never retrieved: {self._exception}", file=sys.stderr)

    def __await__(self) -> Generator[Future[T] | None, None, T | None]:
        while self._state is _PENDING:
            task = getattr(_running, "task", None)
            if task is not None:
                task._awaited = self
            # The runner of the coroutine gets the awaited future. asyncio does not know our futures; after a bare yield, as
            # in real rclpy, makes it come back soon.
            yield None if task is not None or _under_asyncio() else self
        return self.result()

    def _pending(self) -> bool:
        return self._state is _PENDING

    def cancel(self) -> None:
        """Cancel the future unless it is done."""
        with self._lock:
            if self._state is not _PENDING:
                return
            self._state = _CANCELLED
        self._schedule_or_invoke_done_callbacks()

    def cancelled(self) -> bool:
        """Return whether the future was cancelled."""
        return self._state is _CANCELLED

    def done(self) -> bool:
        """Return whether there is a result or an exception (a cancelled future is not done)."""
        return self._state is _FINISHED

    def result(self) -> T | None:
        """Return the result, None if there is none yet; raise the exception if there is one."""
        exception = self.exception()
        if exception is not None:
            raise exception
        return self._result

    def exception(self) -> Exception | None:
        """Return the exception, None if there is none."""
        self._exception_fetched = True
        return self._exception

    def set_result(self, result: T) -> None:
        """Set the result."""
        with self._lock:
            self._result = result
            self._state = _FINISHED
        if self._callbacks or self._watchers:
            self._schedule_or_invoke_done_callbacks()

    def set_exception(self, exception: Exception) -> None:
        """Set an exception instead of a result."""
        with self._lock:
            self._exception = exception
            self._exception_fetched = False
            self._state = _FINISHED
        self._schedule_or_invoke_done_callbacks()

    def _schedule_or_invoke_done_callbacks(self) -> None:
        with self._lock:
            executor = self._executor()
            callbacks, self._callbacks = self._callbacks, []
            watchers, self._watchers = self._watchers, []
        for watcher in watchers:
            watcher()
        for callback in callbacks:
            if executor is not None:
                executor.create_task(callback, self)
                continue
            try:
                callback(self)
            except Exception as error:
                warnings.warn(f"Unhandled exception in done callback: {error}", stacklevel=1)

    def _set_executor(self, executor: Executor | None) -> None:
        with self._lock:
            self._executor = _no_executor if executor is None else weakref.ref(executor)

    def add_done_callback(self, callback: Callable[[Future[T]], object]) -> None:
        """Call `callback(future)` once the future is complete: as a task of its executor if it has one, else at once."""
        with self._lock:
            if self._state is _PENDING:
                self._callbacks.append(callback)
                return
            executor = self._executor()
        if executor is not None:
            executor.create_task(callback, self)
        else:
            callback(self)

    def remove_done_callback(self, callback: Callable[[Future[T]], object]) -> bool:
        """Remove a callback; False if it was not added."""
        with self._lock:
            if callback not in self._callbacks:
                return False
            self._callbacks.remove(callback)
            return True

    def _watch(self, watcher: Callable[[], None]) -> None:
        """Call `watcher()` once, as soon as the future is complete."""
        with self._lock:
            if self._state is _PENDING:
                self._watchers.append(watcher)
                return
        watcher()


class Task(Future[T]):
    """A function or coroutine to be run by calling the task; its return value is the future's result.

    A coroutine runs until it awaits a future that is not complete; each further call continues from there.
    """

    def __init__(
        self,
        handler: Callable[..., Coroutine[object, None, T]] | Callable[..., T],
        args: tuple[object, ...] | None = None,
        kwargs: dict[str, object] | None = None,
        executor: Executor | None = None,
    ) -> None:
        super().__init__(executor=executor)
        self._args = args or ()
        self._kwargs = kwargs or {}
        self._coroutine: Coroutine[object, None, T] | None = None
        self._function: Callable[..., Any] | None = None
        if is_coroutine_function(handler):
            self._coroutine = handler(*self._args, **self._kwargs)  # type: ignore[assignment]
        else:
            self._function = handler
        self._executing = False
        self._awaited: Future[Any] | None = None
        self._task_lock = threading.Lock()

    @property
    def _handler(self) -> object:
        """What is to be run, by the name under which executors of others look whether it is a coroutine."""
        return self._function if self._coroutine is None else self._coroutine

    @classmethod
    def _of_coroutine(cls, coroutine: Coroutine[object, None, T], executor: Executor) -> Task[T]:
        task: Task[T] = cls(_no_function, executor=executor)  # type: ignore[arg-type]
        task._coroutine, task._function = coroutine, None
        return task

    def __call__(self) -> None:
        """Run the function, or the coroutine up to its next await."""
        if self._state is not _PENDING or self._executing or not self._task_lock.acquire(blocking=False):
            return
        try:
            if self._state is not _PENDING:
                return
            self._executing = True
            try:
                if self._coroutine is not None:
                    self._resume(self._coroutine)
                elif self._function is not None:
                    self._run(self._function)
            finally:
                self._executing = False
        finally:
            self._task_lock.release()

    def _run(self, function: Callable[..., T]) -> None:
        try:
            self.set_result(function(*self._args, **self._kwargs))
        except Exception as error:
            self.set_exception(error)
        self._complete_task()

    def _resume(self, coroutine: Coroutine[object, None, T]) -> None:
        outer = getattr(_running, "task", None)
        _running.task = self
        self._awaited = None
        try:
            coroutine.send(None)
        except StopIteration as stop:
            self.set_result(stop.value)
            self._complete_task()
        except Exception as error:
            self.set_exception(error)
            self._complete_task()
        finally:
            _running.task = outer

    def _complete_task(self) -> None:
        self._coroutine = None
        self._function = None
        self._args = ()
        self._kwargs = {}

    def executing(self) -> bool:
        """Return whether the task is running at the moment."""
        return self._executing

    def cancel(self) -> None:
        """Cancel the task; a coroutine is closed where it waits."""
        if self._state is _PENDING and self._coroutine is not None:
            self._coroutine.close()
        super().cancel()


def _under_asyncio() -> bool:
    """Return whether an event loop of asyncio runs on this thread, without importing asyncio."""
    running = getattr(
        sys.modules.get("asyncio.events"), "_get_running_loop", None
    )  # another thread may just be importing it
    return running is not None and running() is not None


def _no_function() -> None:
    """Take the place of a function in a task made from a coroutine."""
