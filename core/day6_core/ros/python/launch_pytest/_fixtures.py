"""The fixtures: the user's, which return what is launched, and those of the plugin that they need, in the same scope."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from typing import TYPE_CHECKING, Any, NamedTuple

import pytest

if TYPE_CHECKING:
    import asyncio

    from launch import LaunchContext, LaunchService

_SCOPES = ("function", "class", "module", "package", "session")


class Options(NamedTuple):
    """What a user's fixture was given; `options_of` finds it again."""

    name: str
    scope: str
    shutdown_when_idle: bool
    auto_shutdown: bool


def options_of(fixture: Any) -> Options | None:
    """Return the options of a fixture or of its function; None if `launch_pytest.fixture` made neither."""
    found = getattr(fixture, "_launch_pytest_options", None)
    return found if isinstance(found, Options) else None


def finish(service: LaunchService, loop: asyncio.AbstractEventLoop, *, auto_shutdown: bool = True) -> None:
    """End a launch, unless it ends itself, and wait for its end. Raises AssertionError if it has failed."""
    if auto_shutdown:
        service.shutdown(force_sync=True)
    if service.task is not None and not loop.is_closed():
        status = loop.run_until_complete(service.task)
        assert status == 0, f"the launch service failed when finishing, return code '{status}'"


def event_loop() -> Iterator[asyncio.AbstractEventLoop]:
    """The asyncio loop in which the launch service and tests that are coroutines run."""
    import asyncio

    loop = asyncio.new_event_loop()
    asyncio.set_event_loop(loop)
    yield loop
    loop.close()
    asyncio.set_event_loop(None)


def launch_service(event_loop: asyncio.AbstractEventLoop) -> Iterator[LaunchService]:
    """The launch service that is tested."""
    from launch import LaunchService

    service = LaunchService()
    yield service
    finish(service, event_loop)


def launch_context(launch_service: LaunchService) -> LaunchContext:
    """The context of the launch service."""
    return launch_service.context


_NEEDED = (event_loop, launch_service, launch_context)


def provide(names: dict[str, Any], scope: str) -> None:
    """Put the plugin's fixtures into a module's names, unless the module has its own or those of a wider scope."""
    for function in _NEEDED:
        name = function.__name__
        known = getattr(names.get(name), "_launch_pytest_scope", None)
        if name not in names or (known is not None and _SCOPES.index(known) < _SCOPES.index(scope)):
            made: Any = pytest.fixture(scope=scope, name=name)(_copy(function))  # type: ignore[call-overload]
            made._launch_pytest_scope = scope
            names[name] = made


def _copy(function: Callable[..., Any]) -> Callable[..., Any]:
    """Return a function of its own: pytest refuses to make two fixtures of one."""
    import types

    made = types.FunctionType(function.__code__, function.__globals__, function.__name__)
    made.__doc__ = function.__doc__
    made.__module__ = function.__module__
    return made


def fixture(
    decorated: Callable[..., Any] | None = None,
    *args: Any,
    shutdown_when_idle: bool = True,
    auto_shutdown: bool = True,
    **kwargs: Any,
) -> Any:
    """Decorate a function that returns a LaunchDescription, or a sequence that begins with one.

    - `shutdown_when_idle`: the launch ends when nothing is left to do. `auto_shutdown`: it is shut down after its tests;
      otherwise it must end itself. All others are those of `pytest.fixture`.
    """

    def decorate(function: Callable[..., Any]) -> Any:
        scope = kwargs.get("scope", "function")
        options = Options(kwargs.get("name") or function.__name__, scope, shutdown_when_idle, auto_shutdown)
        if scope != "function":
            provide(function.__globals__, scope)
        function._launch_pytest_options = options  # type: ignore[attr-defined]
        made: Any = pytest.fixture(*args, **kwargs)(function)
        made._launch_pytest_options = options
        return made

    return decorate if decorated is None else decorate(decorated)
