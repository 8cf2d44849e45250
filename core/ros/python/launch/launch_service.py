"""Runs launch descriptions: processes events one by one, visits what their handlers return, ends when nothing is left."""

from __future__ import annotations

import logging
import signal
import threading
import traceback
from collections import deque
from collections.abc import Callable, Iterable, Iterator
from contextlib import contextmanager
from typing import Any

import launch.logging
from launch import _host
from launch._insistence import Insistence
from launch._loop import Future, Loop
from launch._subprocess import end_all
from launch.event import Event
from launch.event_handlers import OnIncludeLaunchDescription, OnShutdown
from launch.events import IncludeLaunchDescription, Shutdown
from launch.launch_context import LaunchContext
from launch.launch_description import LaunchDescription
from launch.launch_description_entity import LaunchDescriptionEntity
from launch.utilities import visit_all_entities_and_collect_futures

_INTERRUPTED = "user interrupted with ctrl-c (SIGINT)"
SAME_INTERRUPT = 0.5
"""Seconds in which a Ctrl-C may come both as a signal and from the host."""


AFTERMATH = 1.0
"""Seconds for events that lead to events once everything else has ended; then it is for ever."""


class _Cancelled(BaseException):
    """The launch was told to stop at once. No `except Exception` of a launch file is in its way."""


class LaunchService:
    """One launched system. Use: `include_launch_description`, then `run`, which returns the exit status."""

    def __init__(self, *, argv: Iterable[str] | None = None, noninteractive: bool = False, debug: bool = False) -> None:
        launch.logging.launch_config.level = logging.DEBUG if debug else logging.INFO
        self.__logger = launch.logging.get_logger("launch")
        self.__context = LaunchContext(argv=argv, noninteractive=noninteractive)
        self.__context.register_event_handler(OnIncludeLaunchDescription())
        self.__context.register_event_handler(OnShutdown(on_shutdown=self.__on_shutdown))
        self.__pending: list[tuple[LaunchDescriptionEntity, Future]] = []
        self.__loop = Loop()
        self.__running = False
        self.__shutting_down = False
        self.__interrupted: float | None = None
        self.__orders: deque[Callable[[], object]] = deque()
        """What signals ask for; it comes before events, which may never come to an end."""
        self.__insistence: Insistence | None = None
        self.__aftermath: float | None = None

    @property
    def context(self) -> LaunchContext:
        return self.__context

    @property
    def event_loop(self) -> Loop | None:
        return self.__loop if self.__running else None

    def emit_event(self, event: Event) -> None:
        """Queue an event. May be called from any thread, and before `run`."""
        self.__context.emit_event_sync(event)

    def include_launch_description(self, launch_description: LaunchDescription) -> None:
        """Have a launch description visited. May be called from any thread."""
        self.emit_event(IncludeLaunchDescription(launch_description))

    def shutdown(self, force_sync: bool = False) -> None:
        """End the launched system; without effect while it does not run. May be called from any thread."""
        if self.__running:
            self.__loop.call_soon(self._shutdown, "LaunchService.shutdown() called", False)

    # -- running -------------------------------------------------------------------------------------------------------

    def run(self, *, shutdown_when_idle: bool = True) -> int:
        """Run until everything has ended; 1 if there was an exception. RuntimeError outside of the main thread."""
        if threading.current_thread() is not threading.main_thread():
            raise RuntimeError("LaunchService can only be run in the main thread.")
        with self.__signals():
            return self.__run(shutdown_when_idle)

    async def run_async(self, *, shutdown_when_idle: bool = True) -> int:
        """The same for a program that has an asyncio loop: runs in a thread, Ctrl-C is the program's."""
        import asyncio

        return await asyncio.get_running_loop().run_in_executor(None, self.__run, shutdown_when_idle)

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
                    if self.__orders:
                        continue  # a signal was faster: what failed may have failed of it (a command, by the same Ctrl-C)
                    problem = f"Caught exception in launch (see debug for traceback): {error}"
                    self.__logger.debug(traceback.format_exc())
                    self.__logger.error(problem)
                    self.__context._is_broken = True  # what was to start does not
                    self._shutdown(problem, False)
                    status = 1
                else:
                    if self.__goes_on_for_ever():
                        self.__logger.error("events lead to events without end: they are left alone now")
                        return 1
        finally:
            self.__running = self.__shutting_down = False
            self.__context._set_asyncio_loop(None)

    def __step(self, shutdown_when_idle: bool) -> bool:
        """Process one event or run one call; False at the end. Events come first: what a process said before its end."""
        queue = self.__context._event_queue
        while self.__orders:
            self.__orders.popleft()()
        if self.__is_idle():
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

    def __goes_on_for_ever(self) -> bool:
        """Whether nothing is left but events, for a while now, in a launch that has been told to end."""
        if not (self.__shutting_down and self.__context._event_queue) or self.__pending:
            self.__aftermath = None
            return False
        now = self.__loop.time()
        self.__aftermath = self.__aftermath or now
        return now - self.__aftermath > AFTERMATH

    def __is_idle(self) -> bool:
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
        if self.__insistence is None:
            yield
            return
        self.__insistence.visiting = True
        try:
            yield
        finally:
            self.__insistence.visiting = False

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
        insistence = self.__insistence = Insistence(end_all)
        signals_seen = 0

        def order(action: Callable[..., object], argument: object) -> None:
            def obey() -> None:
                insistence.heard()
                action(argument)

            self.__orders.append(obey)
            self.__loop.call_soon(lambda: None)

        def interrupt(number: int, frame: object) -> None:
            nonlocal signals_seen
            if not insistence.check():
                signals_seen += 1
                insistence.told(number, KeyboardInterrupt())
                order(self.__interrupt, signals_seen > 1)

        def terminate(number: int, frame: object) -> None:
            if not insistence.check():
                insistence.told(number, KeyboardInterrupt())
                order(self.__terminate, signal.Signals(number).name)

        wanted: dict[str, Callable[[int, Any], None]] = {
            "SIGINT": interrupt,
            "SIGBREAK": interrupt,  # how day6-tui says Ctrl-C on Windows
            "SIGTERM": terminate,
            "SIGQUIT": terminate,
        }
        before = {
            number: signal.signal(number, handler)
            for name, handler in wanted.items()
            if (number := getattr(signal, name, None)) is not None
        }
        host = _host.host()
        if host is not None:
            host.on_interrupt = lambda: self.__loop.call_soon(self.__interrupt, False)
        try:
            yield
        finally:
            if host is not None:
                host.on_interrupt = None
            for number, handler in before.items():
                signal.signal(number, handler)
            insistence.close()
            self.__insistence = None


def _each(entities: Any) -> list[LaunchDescriptionEntity]:
    found = entities if isinstance(entities, Iterable) else (entities,)
    wanted = [each for each in found if each is not None]
    for each in wanted:
        if not isinstance(each, LaunchDescriptionEntity):
            raise RuntimeError(f"expected a LaunchDescriptionEntity from event_handler, got '{each}'")
    return wanted
