"""The plugin: launches what a test's fixture returns, and runs the test beside the launch or after it.

- functions run in a thread beside the launch, coroutines in the loop `event_loop`; with `shutdown=True` both run after it;
- of generators, plain and asynchronous, the part before `yield` runs beside the launch and the other one after it. Where several
  tests share a launch, the other part is a test of its own, behind all the tests beside the launch.
"""

from __future__ import annotations

import inspect
from collections import defaultdict
from collections.abc import Callable, Generator, Sequence
from functools import partial
from typing import TYPE_CHECKING, Any

import pytest

from launch_pytest import _fixtures
from launch_pytest._fixtures import Options, finish, options_of

if TYPE_CHECKING:
    import asyncio

    from launch import LaunchDescription
    from launch_testing.actions import ReadyToTest

_fixtures.provide(globals(), "function")

_FIRST = pytest.StashKey[pytest.Item]()
"""Of a test that is the second part of a generator: the test that is the first one."""
_BEGUN = pytest.StashKey[Any]()
"""Of a test that is the first part of a generator: the generator, once that part has passed."""


class LaunchTestWarning(pytest.PytestWarning):
    """Something is wrong with how a launch test is marked."""


def pytest_configure(config: pytest.Config) -> None:
    config.addinivalue_line("markers", "launch(fixture, shutdown=False): test what the launch_pytest fixture launches")


# -- the launch --------------------------------------------------------------------------------------------------------


@pytest.hookimpl(wrapper=True, tryfirst=True)
def pytest_fixture_setup(fixturedef: Any, request: Any) -> Generator[None, Any, Any]:
    options = options_of(fixturedef.func)
    if options is None:
        return (yield)
    import asyncio

    service, loop = request.getfixturevalue("launch_service"), request.getfixturevalue("event_loop")
    result = yield
    place = f"When running launch_pytest fixture '{options.name}':"
    description = _description(result, place)
    ready = _ready_action(description)
    service.include_launch_description(description)
    beginning = asyncio.Event()
    ready._add_callback(lambda: loop.call_soon_threadsafe(beginning.set))
    fixturedef.addfinalizer(partial(finish, service, loop, auto_shutdown=options.auto_shutdown))

    async def begin() -> None:
        launched = asyncio.ensure_future(service.run_async(shutdown_when_idle=options.shutdown_when_idle))
        waiting = asyncio.ensure_future(beginning.wait())
        await asyncio.wait([launched, waiting], return_when=asyncio.FIRST_COMPLETED)
        waiting.cancel()

    loop.run_until_complete(begin())
    return result


def _description(result: Any, place: str) -> LaunchDescription:
    from launch import LaunchDescription

    first = result[0] if isinstance(result, Sequence) and result else result
    assert isinstance(first, LaunchDescription), (
        f"{place} return value must be either a launch description or a sequence which first item is a launch description"
    )
    return first


def _ready_action(description: LaunchDescription) -> ReadyToTest:
    """Return the action that starts the tests; it is added at the end if there is none. Raises RuntimeError for several."""
    from launch_testing.actions import ReadyToTest
    from launch_testing.loader import _ready_actions

    found = list(_ready_actions(description.entities))
    if len(found) > 1:
        raise RuntimeError(
            "launch_pytest fixtures must return a LaunchDescription containing only one ReadyToTest action"
        )
    if not found:
        found.append(ReadyToTest())
        description.add_action(found[0])
    return found[0]


# -- collecting --------------------------------------------------------------------------------------------------------


def _is_in_two_parts(function: Any) -> bool:
    return inspect.isgeneratorfunction(function) or inspect.isasyncgenfunction(function)


def _options(item: pytest.Item) -> Options | None:
    mark = item.get_closest_marker("launch")
    return None if mark is None else options_of(mark.kwargs.get("fixture"))


def _is_after_launch(item: pytest.Item) -> bool:
    mark = item.get_closest_marker("launch")
    return _FIRST in item.stash or bool(mark is not None and mark.kwargs.get("shutdown"))


@pytest.hookimpl(tryfirst=True)
def pytest_pycollect_makeitem(collector: Any, name: str, obj: Any) -> list[pytest.Item] | None:
    if not inspect.isfunction(obj) or not collector.funcnamefilter(name):
        return None
    probe = pytest.Function.from_parent(collector, name=name)
    mark = probe.get_closest_marker("launch")
    if mark is None:
        return None
    options = _options(probe)
    if options is None:
        reason = '"fixture" keyword argument is required in a pytest.mark.launch() decorator'
        probe.warn(LaunchTestWarning(reason))
        probe.add_marker(pytest.mark.skip(reason))
        return [probe]
    pytest.mark.usefixtures(options.name, "launch_service", "event_loop")(obj)
    items: list[pytest.Item] = list(collector._genfunctions(name, obj))
    if options.scope != "function" and _is_in_two_parts(obj):
        items += [_second_part(collector, item) for item in items]
    return items


def _second_part(collector: Any, first: Any) -> pytest.Item:
    """Return the test that is the part of a generator behind its `yield`."""
    item = pytest.Function.from_parent(
        collector,
        name=f"{first.name}[shutdown_test]",
        callspec=getattr(first, "callspec", None),
        fixtureinfo=first._fixtureinfo,
        callobj=first.obj,
    )
    item.stash[_FIRST] = first
    return item


@pytest.hookimpl(trylast=True)
def pytest_collection_modifyitems(items: list[pytest.Item]) -> None:
    """Of the tests that share a launch, put those after it behind those beside it."""
    places: defaultdict[tuple[str, ...], list[int]] = defaultdict(list)
    for place, item in enumerate(items):
        options = _options(item)
        if options is not None and options.scope != "function":
            call = getattr(item, "callspec", None)
            chosen = call.indices.get(options.name) if call is not None else None
            places[item.nodeid.partition("::")[0], options.name, str(chosen)].append(place)
    for shared in places.values():
        ordered = sorted((items[place] for place in shared), key=_is_after_launch)
        for place, item in zip(shared, ordered, strict=True):
            items[place] = item


# -- running -----------------------------------------------------------------------------------------------------------


@pytest.hookimpl(tryfirst=True)
def pytest_pyfunc_call(pyfuncitem: pytest.Function) -> bool | None:
    options = _options(pyfuncitem)
    if options is None:
        return None
    function: Callable[..., Any] = pyfuncitem.obj
    values: dict[str, Any] = pyfuncitem.funcargs
    loop = values["event_loop"]
    end = partial(finish, values["launch_service"], loop, auto_shutdown=options.auto_shutdown)
    if _FIRST in pyfuncitem.stash:
        begun = pyfuncitem.stash[_FIRST].stash.get(_BEGUN, None)
        if begun is None:
            pytest.skip("shutdown test skipped because the test failed before")
        end()
        _finish_generator(begun, loop)
        return True
    marks = [mark for mark in pyfuncitem.iter_markers("launch") if mark.kwargs.get("shutdown")]
    if marks and _is_in_two_parts(function):
        pytest.fail(
            "generator or async generator based launch test items cannot be marked with shutdown=True", pytrace=False
        )
    if marks:
        end()
    arguments = {name: values[name] for name in pyfuncitem._fixtureinfo.argnames}
    if _is_in_two_parts(function):
        generator = function(**arguments)
        _advance(generator, loop)
        pyfuncitem.stash[_BEGUN] = generator
        if options.scope == "function":
            end()
            _finish_generator(generator, loop)
    elif inspect.iscoroutinefunction(function):
        loop.run_until_complete(function(**arguments))
    else:
        loop.run_until_complete(loop.run_in_executor(None, partial(function, **arguments)))
    return True


def _advance(generator: Any, loop: asyncio.AbstractEventLoop) -> bool:
    """Run a generator up to its next `yield`; returns whether there was one."""
    ended = object()

    async def step() -> Any:
        return await anext(generator, ended)

    if inspect.isasyncgen(generator):
        return loop.run_until_complete(step()) is not ended
    return loop.run_until_complete(loop.run_in_executor(None, next, generator, ended)) is not ended


def _finish_generator(generator: Any, loop: asyncio.AbstractEventLoop) -> None:
    if _advance(generator, loop):
        kind = "an async gen" if inspect.isasyncgen(generator) else "a generator"
        pytest.fail(f"launch tests using {kind} function must stop iteration after yielding once", pytrace=False)
