"""Small things that commands share."""

from __future__ import annotations

import functools
import inspect
import os
import sys
import time
from collections.abc import Callable
from typing import Any

from day6_core.ros.ros2.cli.options import unsigned_int as unsigned_int


def get_ros_domain_id() -> int:
    """Return the domain of this process."""
    return int(os.environ.get("ROS_DOMAIN_ID", 0))


def wait_for(predicate: Callable[[], bool], timeout: float, period: float = 0.1) -> bool:
    """Return whether the predicate comes true within `timeout` seconds; a negative number waits for ever."""
    deadline = time.time() + timeout if timeout >= 0 else float("inf")
    while not predicate():
        if time.time() > deadline:
            return predicate()
        time.sleep(period)
    return True


def bind(func: Callable[..., Any], *args: Any, **kwargs: Any) -> Callable[..., Any]:
    """Return a function like functools.partial's object."""

    @functools.wraps(func)
    def bound(*more: Any, **others: Any) -> Any:
        return func(*args, *more, **{**kwargs, **others})

    return bound


def pretty_print_call(func: Callable[..., Any], *args: Any, **kwargs: Any) -> None:
    """Print a call as Python writes it."""
    words = [*map(repr, args), *(f"{name}={value!r}" for name, value in kwargs.items())]
    print(f"{func.__name__}({', '.join(words)})")


def before_invocation(func: Callable[..., Any], hook: Callable[..., Any]) -> Callable[..., Any]:
    """Return a function that calls a hook first, with the function and its arguments if the hook takes any."""
    takes = len(inspect.signature(hook).parameters) > 0

    @functools.wraps(func)
    def wrapper(*args: Any, **kwargs: Any) -> Any:
        if takes:
            hook(func, *args, **kwargs)
        else:
            hook()
        return func(*args, **kwargs)

    return wrapper


def collect_stdin() -> bytes:
    """Return what comes on standard input until its end."""
    return sys.stdin.buffer.read()


__all__ = [
    "before_invocation",
    "bind",
    "collect_stdin",
    "get_ros_domain_id",
    "pretty_print_call",
    "unsigned_int",
    "wait_for",
]
