"""The event loop of a launch: one thread that runs calls and timers when they are due, and sleeps otherwise.

Threads watch the processes, timers wait here; both only ever put a call into the inbox. No asyncio: every launch would
pay for its import, and on Windows its subprocesses need another kind of loop. The names that launch files may use are those of
an asyncio loop (`context.asyncio_loop.call_soon_threadsafe …`).
"""

from __future__ import annotations

import heapq
import itertools
import threading
import time
from collections.abc import Callable, Coroutine
from queue import Empty
from typing import Any

from day6_core.inbox import Inbox


class Future:
    """A result that is available later, as asyncio.Future. Only the loop's thread uses it."""

    def __init__(self) -> None:
        self._done = False
        self._cancelled = False
        self._result: Any = None
        self._exception: BaseException | None = None
        self._callbacks: list[Callable[[Future], object]] = []

    def done(self) -> bool:
        return self._done

    def cancelled(self) -> bool:
        return self._cancelled

    def result(self) -> Any:
        if self._exception is not None:
            raise self._exception
        return self._result

    def exception(self) -> BaseException | None:
        return self._exception

    def set_result(self, result: Any) -> None:
        self._result = result
        self._finish()

    def set_exception(self, exception: BaseException) -> None:
        self._exception = exception
        self._finish()

    def cancel(self) -> bool:
        """End it without a result; returns False if it was done already."""
        if self._done:
            return False
        self._cancelled = True
        self._finish()
        return True

    def add_done_callback(self, function: Callable[[Future], object]) -> None:
        if self._done:
            function(self)
        else:
            self._callbacks.append(function)

    def _finish(self) -> None:
        if self._done:
            raise RuntimeError("this future is done already")
        self._done = True
        callbacks, self._callbacks = self._callbacks, []
        for function in callbacks:
            function(self)


class Timer:
    """A call that is due later, as asyncio.TimerHandle."""

    def __init__(self, function: Callable[[], object]) -> None:
        self._function: Callable[[], object] | None = function

    def cancel(self) -> None:
        self._function = None

    def fire(self) -> None:
        """Run the call, unless it was cancelled."""
        function, self._function = self._function, None
        if function is not None:
            function()


class CoroutineFuture(Future):
    """The future of a coroutine that asyncio runs in a separate thread."""

    def __init__(self) -> None:
        super().__init__()
        self.stop: Callable[[], object] | None = None

    def cancel(self) -> bool:
        stop = self.stop
        if stop is not None:
            stop()
        return super().cancel()


class Loop:
    """See the module's docstring. `run_next` is for the loop's own thread, `call_soon_threadsafe` for all threads."""

    def __init__(self) -> None:
        self._inbox: Inbox[Callable[[], object]] = Inbox()
        self._timers: list[tuple[float, int, Timer]] = []
        self._count = itertools.count()
        self._thread: int | None = None
        self._called = False
        """The last one run was a call, not a timer: they take turns, so that neither can starve the other."""

    def adopt(self) -> None:
        """Make the calling thread the one that runs this loop."""
        self._thread = threading.get_ident()

    def is_here(self) -> bool:
        """Return whether the calling thread runs this loop."""
        return self._thread in (None, threading.get_ident())

    def time(self) -> float:
        """Return the loop's clock, in seconds."""
        return time.monotonic()

    def create_future(self) -> Future:
        return Future()

    def call_soon(self, function: Callable[..., object], *args: Any) -> None:
        """Run a call as soon as possible. May be called from any thread."""
        self._inbox.put(lambda: function(*args))

    call_soon_threadsafe = call_soon

    def call_later(self, delay: float, function: Callable[..., object], *args: Any) -> Timer:
        """Run a call after `delay` seconds."""
        timer = Timer(lambda: function(*args))
        heapq.heappush(self._timers, (self.time() + delay, next(self._count), timer))
        return timer

    def run_in_executor(self, executor: None, function: Callable[..., Any], *args: Any) -> Future:
        """Run a function in a thread; the future gets what it returns or raises."""
        future = Future()

        def work() -> None:
            try:
                result = function(*args)
            except BaseException as error:
                self.call_soon(_settle, future, None, error)
            else:
                self.call_soon(_settle, future, result, None)

        threading.Thread(target=work, name="launch-work", daemon=True).start()
        return future

    def create_task(self, coroutine: Coroutine[Any, Any, Any]) -> Future:
        """Let asyncio run a coroutine in a thread. It may use all of asyncio, and the thread-safe parts of launch."""
        future = CoroutineFuture()

        def work() -> None:
            import asyncio

            async def run() -> Any:
                task, loop = asyncio.current_task(), asyncio.get_running_loop()
                if task is not None:
                    future.stop = lambda: loop.call_soon_threadsafe(task.cancel)
                try:
                    return await coroutine
                finally:
                    future.stop = None

            try:
                result = asyncio.run(run())
            except asyncio.CancelledError:
                return
            except BaseException as error:
                self.call_soon(_settle, future, None, error)
            else:
                self.call_soon(_settle, future, result, None)

        threading.Thread(target=work, name="launch-coroutine", daemon=True).start()
        return future

    def run_next(self, *, wait: bool = True) -> bool:
        """Run one call that is due, waiting for it with `wait`; returns False if there was none."""
        while True:
            delay = self._delay()
            if delay is not None and delay <= 0 and (self._called or self._inbox.empty()):
                self._called = False
                heapq.heappop(self._timers)[2].fire()
                return True
            self._called = True
            if delay is not None and delay <= 0:
                self._inbox.get()()
                return True
            try:
                # On Windows only a wait with a timeout lets Ctrl-C through.
                call = (
                    self._inbox.get(timeout=min(delay, 1.0) if delay is not None else 1.0)
                    if wait
                    else (self._inbox.get_nowait())
                )
            except Empty:
                if not wait:
                    return False
                continue
            call()
            return True

    def _delay(self) -> float | None:
        while self._timers and self._timers[0][2]._function is None:
            heapq.heappop(self._timers)
        return self._timers[0][0] - self.time() if self._timers else None


def _settle(future: Future, result: Any, error: BaseException | None) -> None:
    if future.done():
        return
    if error is not None:
        future.set_exception(error)
    else:
        future.set_result(result)
