"""The state of one launch: configurations, environment, event queue and handlers."""

from __future__ import annotations

import os
from collections import deque
from collections.abc import Iterable, Mapping, MutableMapping
from typing import TYPE_CHECKING, Any

import launch.logging
from launch._loop import Future, Loop
from launch.event import Event
from launch.event_handler import BaseEventHandler
from launch.substitution import Substitution

if TYPE_CHECKING:
    from launch._host import HostConnection


class EventQueue(deque[Event]):
    """The events to come; tests of launch files use the names that an asyncio.Queue has."""

    qsize = deque.__len__
    get_nowait = deque.popleft


class Locals:
    """`context.locals`: values from event handlers and includes, as read-only attributes."""

    def __init__(self, values: dict[str, Any]) -> None:
        self.__dict__["_values"] = values

    def __getattr__(self, key: str) -> Any:
        values = self.__dict__["_values"]
        if key not in values:
            raise AttributeError(
                f"context.locals does not contain attribute '{key}', it contains: [{', '.join(values)}]"
            )
        return values[key]

    def __setattr__(self, key: str, value: Any) -> None:
        raise AttributeError(f"can't set attribute '{key}', locals are read-only")


class LaunchContext:
    """The context that actions and substitutions are given. Its environment is this process's (`os.environ`)."""

    def __init__(self, *, argv: Iterable[str] | None = None, noninteractive: bool = False) -> None:
        self.__argv = argv if argv is not None else []
        self.__noninteractive = noninteractive
        self._event_queue = EventQueue()
        self._event_handlers: deque[BaseEventHandler] = deque()
        self._completion_futures: list[Future] = []
        self.__globals: dict[str, Any] = {}
        self.__locals: dict[str, Any] = {}
        self.__locals_stack: list[dict[str, Any]] = []
        self.__launch_configurations: dict[str, Any] = {}
        self.__launch_configurations_stack: list[dict[str, Any]] = []
        self.__environment_at_start: Mapping[str, str] = dict(os.environ)
        self.__environment_stack: list[Mapping[str, str]] = []
        self.__is_shutdown = False
        self._is_broken = False
        self._host: HostConnection | None = None
        """The process that started this launch and runs our programs for it, if there is one."""
        self.__loop: Loop | None = None
        self.__logger = launch.logging.get_logger(__name__)

    @property
    def argv(self) -> Iterable[str]:
        return self.__argv

    @property
    def noninteractive(self) -> bool:
        return self.__noninteractive

    @property
    def is_shutdown(self) -> bool:
        return self.__is_shutdown

    def _set_is_shutdown(self, state: bool) -> None:
        self.__is_shutdown = state

    @property
    def asyncio_loop(self) -> Any:
        """The loop of the running launch (`launch._loop.Loop`), None while none runs."""
        return self.__loop

    def _set_asyncio_loop(self, loop: Loop | None) -> None:
        self.__loop = loop

    def add_completion_future(self, completion_future: Future) -> None:
        """Keep the launch running until this future is done too."""
        self._completion_futures.append(completion_future)

    # -- locals --------------------------------------------------------------------------------------------------------

    def extend_globals(self, extensions: Mapping[str, Any]) -> None:
        """Add to `locals` permanently; locals of the same name hide them."""
        self.__globals.update(extensions)

    def extend_locals(self, extensions: Mapping[str, Any]) -> None:
        """Add to `locals` until the current event has been processed."""
        self.__locals.update(extensions)

    def get_locals_as_dict(self) -> dict[str, Any]:
        """Return globals and locals in one dict."""
        return {**self.__globals, **self.__locals}

    @property
    def locals(self) -> Locals:
        """The globals and locals, as attributes."""
        return Locals(self.get_locals_as_dict())

    def _push_locals(self) -> None:
        self.__locals_stack.append(dict(self.__locals))

    def _pop_locals(self) -> None:
        if not self.__locals_stack:
            raise RuntimeError("locals stack unexpectedly empty")
        self.__locals = self.__locals_stack.pop()

    # -- environment and launch configurations -------------------------------------------------------------------------

    @property
    def environment(self) -> MutableMapping[str, str]:
        """The environment of this process."""
        return os.environ

    def _push_environment(self) -> None:
        self.__environment_stack.append(dict(os.environ))

    def _pop_environment(self) -> None:
        if not self.__environment_stack:
            raise RuntimeError("environment stack unexpectedly empty")
        _set_environment(self.__environment_stack.pop())

    def _reset_environment(self) -> None:
        _set_environment(self.__environment_at_start)

    @property
    def launch_configurations(self) -> dict[str, Any]:
        """`{name: text}`; launch_ros keeps lists there too."""
        return self.__launch_configurations

    def _push_launch_configurations(self) -> None:
        self.__launch_configurations_stack.append(dict(self.__launch_configurations))

    def _pop_launch_configurations(self) -> None:
        if not self.__launch_configurations_stack:
            raise RuntimeError("launch_configurations stack unexpectedly empty")
        self.__launch_configurations = self.__launch_configurations_stack.pop()

    # -- events --------------------------------------------------------------------------------------------------------

    def would_handle_event(self, event: Event) -> bool:
        """Return whether any handler matches an event."""
        return any(handler.matches(event) for handler in self._event_handlers)

    def register_event_handler(self, event_handler: BaseEventHandler, append: bool = False) -> None:
        """Add a handler before the others, or after them with `append`."""
        if append:
            self._event_handlers.append(event_handler)
        else:
            self._event_handlers.appendleft(event_handler)

    def unregister_event_handler(self, event_handler: BaseEventHandler) -> None:
        """Remove a handler. Raises ValueError if it isn't registered."""
        self._event_handlers.remove(event_handler)

    def emit_event_sync(self, event: Event) -> None:
        """Queue an event. May be called from any thread."""
        self.__logger.debug(f"emitting event synchronously: '{event.name}'")
        self._queue(event)

    async def emit_event(self, event: Event) -> None:
        """Queue an event, from a coroutine."""
        self._emit_event(event)

    def _emit_event(self, event: Event) -> None:
        self.__logger.debug(f"emitting event: '{event.name}'")
        self._queue(event)

    def _queue(self, event: Event) -> None:
        self._event_queue.append(event)
        if self.__loop is not None and not self.__loop.is_here():
            self.__loop.call_soon(lambda: None)  # the loop checks the event queue after each call

    def perform_substitution(self, substitution: Substitution) -> str:
        """Return the text of a substitution. Raises SubstitutionFailure."""
        return substitution.perform(self)


def _set_environment(values: Mapping[str, str]) -> None:
    os.environ.clear()
    os.environ.update(values)
