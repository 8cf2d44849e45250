"""Runs launch descriptions: processes events one by one, visits what their handlers return, ends when nothing is left."""

from __future__ import annotations

import logging
import signal
import threading
import traceback
from collections import deque
from collections.abc import Callable, Coroutine, Generator, Iterable, Iterator
from contextlib import contextmanager
from typing import TYPE_CHECKING, Any

import launch.logging
from launch._loop import Future, Loop
from launch._signal_watchdog import SignalWatchdog
from launch._subprocess import end_all
from launch.event import Event
from launch.event_handlers import OnIncludeLaunchDescription, OnShutdown
from launch.events import IncludeLaunchDescription, Shutdown
from launch.launch_context import LaunchContext
from launch.launch_description import LaunchDescription
from launch.launch_description_entity import LaunchDescriptionEntity
from launch.utilities import visit_all_entities_and_collect_futures

if TYPE_CHECKING:
    from launch._host import HostConnection

_INTERRUPTED = "user interrupted with ctrl-c (SIGINT)"
SAME_INTERRUPT = 0.5
"""Seconds in which a Ctrl-C may come both as a signal and from the host."""


AFTERMATH = 1.0
"""How long events may go on causing events once everything else has ended; beyond that it counts as endless."""


class _Done(Coroutine[Any, Any, None]):
    """What `shutdown` returns: it may be awaited, or left, because the shutdown is under way already."""

    def send(self, value: Any) -> Any:
        raise StopIteration

    def throw(self, *error: Any) -> Any:
        raise error[0]

    def close(self) -> None:
        return

    def __await__(self) -> Generator[Any, Any, None]:
        return
        yield


class _Cancelled(BaseException):
    """The launch must stop at once. No `except Exception` of a launch file catches this."""


class LaunchService:
    """One launched system. Use: `include_launch_description`, then `run`, which returns the exit status."""

    def __init__(
        self,
        *,
        argv: Iterable[str] | None = None,
        noninteractive: bool = False,
        debug: bool = False,
        log_file_name: str | None = None,
    ) -> None:
        launch.logging.launch_config.level = logging.DEBUG if debug else logging.INFO
        if log_file_name is not None:
            launch.logging.launch_config.file_name = f"{log_file_name.removesuffix('.log')}.log"
        self.__logger = launch.logging.get_logger("launch")
        self.__context = LaunchContext(argv=argv, noninteractive=noninteractive)
        self.__context.register_event_handler(OnIncludeLaunchDescription())
        self.__context.register_event_handler(OnShutdown(on_shutdown=self.__on_shutdown))
        self.__pending: list[tuple[LaunchDescriptionEntity, Future]] = []
        self.__loop = Loop()
        self.__running = False
        self.__shutting_down = False
        self.__interrupted: float | None = None
        self.__signal_calls: deque[Callable[[], object]] = deque()
        """Calls from signal handlers; they come before events, which may never come to an end."""
        self.__watchdog: SignalWatchdog | None = None
        self.__aftermath: float | None = None
        self.__task: Any = None
        self.__outer: Any = None
        """The task of `run_async` and the asyncio loop that it runs in."""

    @property
    def task(self) -> Any:
        """The asyncio task that runs this, None while there is none."""
        return self.__task

    @property
    def context(self) -> LaunchContext:
        return self.__context

    @property
    def event_loop(self) -> Any:
        """The asyncio loop of `run_async`, or the launch's own one of `run`; None while it doesn't run."""
        return self.__outer or (self.__loop if self.__running else None)

    def _run_programs_with(self, host: HostConnection | None) -> None:
        """Let the host that started this launch run our programs. Call it before `run`."""
        self.__context._host = host

    def emit_event(self, event: Event) -> None:
        """Queue an event. May be called from any thread, and before `run`."""
        self.__context.emit_event_sync(event)

    def include_launch_description(self, launch_description: LaunchDescription) -> None:
        """Queue a launch description to be visited. May be called from any thread."""
        self.emit_event(IncludeLaunchDescription(launch_description))

    def shutdown(self, force_sync: bool = False) -> Coroutine[Any, Any, None] | None:
        """Shut the launched system down; no effect unless it runs. May be called from any thread.

        While it runs, and without `force_sync`, this returns something to await, as real launch does.
        """
        if not self.__running:
            return None
        self.__loop.call_soon(self._shutdown, "LaunchService.shutdown() called", False)
        return None if force_sync else _Done()

    # -- running -------------------------------------------------------------------------------------------------------

    def run(self, *, shutdown_when_idle: bool = True) -> int:
        """Run until everything has ended; returns 1 if there was an exception. Raises RuntimeError off the main thread."""
        if threading.current_thread() is not threading.main_thread():
            raise RuntimeError("LaunchService can only be run in the main thread.")
        with self.__signals():
            return self.__run(shutdown_when_idle)

    async def run_async(self, *, shutdown_when_idle: bool = True) -> int:
        """Like `run`, for a program with an asyncio loop: runs in a thread and leaves Ctrl-C to the program."""
        import asyncio

        self.__task, self.__outer = asyncio.current_task(), asyncio.get_running_loop()
        try:
            status: int = await self.__outer.run_in_executor(None, self.__run, shutdown_when_idle)
            return status
        finally:
            self.__task = self.__outer = None

    def __run(self, shutdown_when_idle: bool) -> int:
        if self.__running:
            raise RuntimeError("LaunchService cannot be run multiple times concurrently.")
        self.__running = True
        self.__loop.adopt()
        self.__context._set_asyncio_loop(self.__loop)
        status = 0
        try:
            launch.logging.log_launch_config(logger=self.__logger)
            while True:
                try:
                    if not self.__step(shutdown_when_idle):
                        return status
                except KeyboardInterrupt:
                    continue
                except _Cancelled:
                    self.__logger.error("run task was canceled")
                    end_all()
                    return 1
                except Exception as error:
                    if self.__signal_calls:
                        continue  # a signal came first: it may have caused the failure (of a command, by the same Ctrl-C)
                    problem = f"Caught exception in launch (see debug for traceback): {error}"
                    self.__logger.debug(traceback.format_exc())
                    self.__logger.error(problem)
                    self.__context._is_broken = True  # processes that haven't started will not
                    self._shutdown(problem, False)
                    status = 1
                else:
                    if self.__is_endless():
                        self.__logger.error("events keep causing events: the remaining ones are ignored")
                        return 1
        finally:
            self.__running = self.__shutting_down = False
            self.__context._set_asyncio_loop(None)

    def __step(self, shutdown_when_idle: bool) -> bool:
        """Process one event or run one call; returns False at the end. Events come first: a process's output before its end."""
        queue = self.__context._event_queue
        while self.__signal_calls:
            self.__signal_calls.popleft()()
        if self._is_idle():
            if self.__shutting_down:
                return self.__loop.run_next(wait=False)
            if shutdown_when_idle and not self.__loop.run_next(wait=False):
                self._shutdown("idle", False)
            elif not shutdown_when_idle:
                self.__loop.run_next()
        elif queue:
            self.__process(queue.popleft())
        else:
            self.__loop.run_next()
        return True

    def __is_endless(self) -> bool:
        """Return whether a launch that is shutting down has had nothing but events for a while now."""
        if not (self.__shutting_down and self.__context._event_queue) or self.__pending:
            self.__aftermath = None
            return False
        now = self.__loop.time()
        self.__aftermath = self.__aftermath or now
        return now - self.__aftermath > AFTERMATH

    def _is_idle(self) -> bool:
        self.__pending = [pair for pair in self.__pending if not self.__ended(pair[1])]
        futures = self.__context._completion_futures
        self.__context._completion_futures = [future for future in futures if not self.__ended(future)]
        return not (self.__pending or self.__context._completion_futures or self.__context._event_queue)

    def __ended(self, future: Future) -> bool:
        if not future.done():
            return False
        if future.cancelled():
            return True
        error = future.exception()
        if error is not None:
            self.__pending = [pair for pair in self.__pending if pair[1] is not future]
            completions = self.__context._completion_futures
            self.__context._completion_futures = [each for each in completions if each is not future]
            raise error
        return True

    def __process(self, event: Event) -> None:
        self.__logger.debug(f"processing event: '{event}'")
        for handler in tuple(self.__context._event_handlers):
            if not handler.matches(event):
                continue
            self.__logger.debug(f"processing event: '{event}' ✓ '{handler}'")
            self.__context._push_locals()
            try:
                with self.__interruptible():
                    entities = handler.handle(event, self.__context)
                    for entity in _each(entities):
                        self.__pending.extend(visit_all_entities_and_collect_futures(entity, self.__context))
            finally:
                self.__context._pop_locals()

    @contextmanager
    def __interruptible(self) -> Iterator[None]:
        if self.__watchdog is None:
            yield
            return
        self.__watchdog.visiting = True
        try:
            yield
        finally:
            self.__watchdog.visiting = False

    # -- the end -------------------------------------------------------------------------------------------------------

    def __on_shutdown(self, event: Shutdown, context: LaunchContext) -> None:
        self.__shutting_down = True
        context._set_is_shutdown(True)

    def _shutdown(self, reason: str, due_to_sigint: bool, synchronously: bool = False) -> None:
        if not self.__shutting_down:
            event = Shutdown(reason=reason, due_to_sigint=due_to_sigint)
            (self.__context.emit_event_sync if synchronously else self.__context._emit_event)(event)
        self.__shutting_down = True
        self.__context._set_is_shutdown(True)

    def __interrupt(self, again: bool) -> None:
        now = self.__loop.time()
        before = self.__interrupted
        self.__interrupted = now
        if before is None:
            self.__logger.warning(_INTERRUPTED)
            self._shutdown("ctrl-c (SIGINT)", True, synchronously=True)
        elif again or now - before > SAME_INTERRUPT:
            self.__logger.warning(f"{_INTERRUPTED} again, ignoring...")

    def __terminate(self, name: str) -> None:
        self.__logger.error(f"user interrupted with ctrl-\\ ({name}), terminating...")
        self.__logger.error(f"using {name} can result in orphaned processes")
        self.__logger.error("make sure no processes launched are still running")
        raise _Cancelled

    @contextmanager
    def __signals(self) -> Iterator[None]:
        watchdog = self.__watchdog = SignalWatchdog(end_all)
        signals_seen = 0

        def enqueue(action: Callable[..., object], argument: object) -> None:
            def call() -> None:
                watchdog.mark_handled()
                action(argument)

            self.__signal_calls.append(call)
            self.__loop.call_soon(lambda: None)

        def interrupt(number: int, frame: object) -> None:
            nonlocal signals_seen
            if not watchdog.check():
                signals_seen += 1
                watchdog.received(number, KeyboardInterrupt())
                enqueue(self.__interrupt, signals_seen > 1)

        def terminate(number: int, frame: object) -> None:
            if not watchdog.check():
                watchdog.received(number, KeyboardInterrupt())
                enqueue(self.__terminate, signal.Signals(number).name)

        wanted: dict[str, Callable[[int, Any], None]] = {
            "SIGINT": interrupt,
            "SIGBREAK": interrupt,  # how day6-tui sends Ctrl-C on Windows
            "SIGTERM": terminate,
            "SIGQUIT": terminate,
        }
        before = {
            number: signal.signal(number, handler)
            for name, handler in wanted.items()
            if (number := getattr(signal, name, None)) is not None
        }
        host = self.__context._host
        if host is not None:
            host.on_interrupt = lambda: self.__loop.call_soon(self.__interrupt, False)
        try:
            yield
        finally:
            if host is not None:
                host.on_interrupt = None
            for number, handler in before.items():
                signal.signal(number, handler)
            watchdog.close()
            self.__watchdog = None


def _each(entities: Any) -> list[LaunchDescriptionEntity]:
    found = entities if isinstance(entities, Iterable) else (entities,)
    wanted = [each for each in found if each is not None]
    for each in wanted:
        if not isinstance(each, LaunchDescriptionEntity):
            raise RuntimeError(f"expected a LaunchDescriptionEntity from event_handler, got '{each}'")
    return wanted
