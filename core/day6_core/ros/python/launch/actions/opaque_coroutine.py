"""Runs a coroutine."""

from __future__ import annotations

import inspect
from collections.abc import Awaitable, Callable, Iterable, Sequence
from typing import TYPE_CHECKING, Any

from launch.action import Action
from launch.event_handlers.on_shutdown import OnShutdown
from launch.launch_description_entity import LaunchDescriptionEntity
from launch.utilities import ensure_argument_type

if TYPE_CHECKING:
    from launch._loop import Future
    from launch.events.shutdown import Shutdown
    from launch.launch_context import LaunchContext


class OpaqueCoroutine(Action):
    """Runs `coroutine(context, *args, **kwargs)` until it or the launch ends; `ignore_context`: without `context`."""

    def __init__(
        self,
        *,
        coroutine: Callable[..., Awaitable[None]],
        args: Iterable[Any] | None = None,
        kwargs: dict[str, Any] | None = None,
        ignore_context: bool = False,
        **left_over_kwargs: Any,
    ) -> None:
        super().__init__(**left_over_kwargs)
        if not inspect.iscoroutinefunction(coroutine):
            raise TypeError(f"OpaqueCoroutine expected a coroutine function for 'coroutine', got '{type(coroutine)}'")
        ensure_argument_type(args, (Iterable, type(None)), "args", "OpaqueCoroutine")
        ensure_argument_type(kwargs, (dict, type(None)), "kwargs", "OpaqueCoroutine")
        ensure_argument_type(ignore_context, bool, "ignore_context", "OpaqueCoroutine")
        self.__coroutine = coroutine
        self.__args = [] if args is None else args
        self.__kwargs = {} if kwargs is None else kwargs
        self.__ignore_context = ignore_context
        self.__future: Future | None = None

    def __on_shutdown(self, event: Shutdown, context: LaunchContext) -> None:
        if self.__future is not None:
            self.__future.cancel()

    def execute(self, context: LaunchContext) -> Sequence[LaunchDescriptionEntity] | None:
        args = self.__args if self.__ignore_context else [context, *self.__args]
        self.__future = context.asyncio_loop.create_task(self.__coroutine(*args, **self.__kwargs))
        context.register_event_handler(OnShutdown(on_shutdown=self.__on_shutdown))
        return None

    def get_asyncio_future(self) -> Future | None:
        return self.__future
