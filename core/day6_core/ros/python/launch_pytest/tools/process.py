"""Waits for the start, the output and the end of a process; each in a thread (`…_sync`) and as a coroutine.

A process of which output is looked at must have `cached_output=True`. `timeout` is in seconds; None is for ever.
"""

from __future__ import annotations

import threading
import time
from collections.abc import Callable, Coroutine
from typing import Any

from launch import LaunchContext
from launch.actions import ExecuteProcess
from launch.event_handlers import OnProcessExit, OnProcessIO, OnProcessStart

Validate = Callable[[str], Any]


def _wait(
    context: LaunchContext, handler: Any, happened: threading.Event, condition: Callable[[], Any], timeout: Any
) -> Any:
    """Look at a condition now and at each event, until it holds; returns its last value."""
    until = None if timeout is None else time.monotonic() + timeout
    context.register_event_handler(handler, append=True)
    try:
        while not (value := condition()):
            left = None if until is None else until - time.monotonic()
            if (left is not None and left <= 0) or not happened.wait(left):
                return condition()
            happened.clear()
        return value
    finally:
        context.unregister_event_handler(handler)


def _holds(validate: Validate, text: str) -> bool:
    try:
        validate(text)
    except AssertionError:
        return False
    return True


def _wait_for_text(
    context: LaunchContext, action: ExecuteProcess, stream: str, condition: Validate, timeout: float | None
) -> Any:
    happened = threading.Event()
    handler: Any = OnProcessIO(target_action=action, **{f"on_{stream}": lambda event: happened.set()})
    read = getattr(action, f"get_{stream}")
    return _wait(context, handler, happened, lambda: condition(read()), timeout)


def _assert_text(
    context: LaunchContext, action: ExecuteProcess, stream: str, validate: Validate, timeout: float | None
) -> None:
    if not _wait_for_text(context, action, stream, lambda text: _holds(validate, text), timeout):
        validate(getattr(action, f"get_{stream}")())


def wait_for_output_sync(
    launch_context: LaunchContext,
    execute_process_action: ExecuteProcess,
    validate_output: Validate,
    timeout: float | None = None,
) -> Any:
    """Wait until a function of the standard output returns something true; returns what it returned last."""
    return _wait_for_text(launch_context, execute_process_action, "stdout", validate_output, timeout)


def wait_for_stderr_sync(
    launch_context: LaunchContext,
    execute_process_action: ExecuteProcess,
    validate_output: Validate,
    timeout: float | None = None,
) -> Any:
    """As `wait_for_output_sync`, of the standard error."""
    return _wait_for_text(launch_context, execute_process_action, "stderr", validate_output, timeout)


def assert_output_sync(
    launch_context: LaunchContext,
    execute_process_action: ExecuteProcess,
    validate_output: Validate,
    timeout: float | None = None,
) -> None:
    """Wait until a function of the standard output raises no AssertionError; raises its last one."""
    _assert_text(launch_context, execute_process_action, "stdout", validate_output, timeout)


def assert_stderr_sync(
    launch_context: LaunchContext,
    execute_process_action: ExecuteProcess,
    validate_output: Validate,
    timeout: float | None = None,
) -> None:
    """As `assert_output_sync`, of the standard error."""
    _assert_text(launch_context, execute_process_action, "stderr", validate_output, timeout)


def wait_for_start_sync(
    launch_context: LaunchContext, execute_process_action: ExecuteProcess, timeout: float | None = None
) -> bool:
    """Wait until the process runs, or has run; returns whether it does."""
    happened = threading.Event()
    handler = OnProcessStart(target_action=execute_process_action, on_start=lambda event, context: happened.set())

    def runs() -> bool:
        return "pid" in (execute_process_action.process_details or {})

    return bool(_wait(launch_context, handler, happened, runs, timeout))


def wait_for_exit_sync(
    launch_context: LaunchContext, execute_process_action: ExecuteProcess, timeout: float | None = None
) -> bool:
    """Wait until the process has ended; returns whether it has."""
    happened = threading.Event()
    handler = OnProcessExit(target_action=execute_process_action, on_exit=lambda event, context: happened.set())
    return bool(
        _wait(launch_context, handler, happened, lambda: execute_process_action.return_code is not None, timeout)
    )


def _as_coroutine(function: Callable[..., Any]) -> Callable[..., Coroutine[Any, Any, Any]]:
    async def wait(*args: Any, **kwargs: Any) -> Any:
        import asyncio

        return await asyncio.to_thread(function, *args, **kwargs)

    wait.__doc__ = f"`{function.__name__}` as a coroutine."
    return wait


wait_for_output = _as_coroutine(wait_for_output_sync)
wait_for_stderr = _as_coroutine(wait_for_stderr_sync)
assert_output = _as_coroutine(assert_output_sync)
assert_stderr = _as_coroutine(assert_stderr_sync)
wait_for_start = _as_coroutine(wait_for_start_sync)
wait_for_exit = _as_coroutine(wait_for_exit_sync)
