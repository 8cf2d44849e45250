"""Markers of launch descriptions and of tests."""

from __future__ import annotations

import functools
import inspect
import time
from collections.abc import Callable
from typing import Any, TypeVar

_Function = TypeVar("_Function", bound=Callable[..., Any])


def keep_alive(test_description: _Function) -> _Function:
    """Mark a `generate_test_description` whose launch goes on when all its processes have ended, until the tests are done."""
    markers: dict[str, Any] = test_description.__dict__.setdefault("__markers__", {})
    markers["keep_alive"] = True
    return test_description


def retry_on_failure(*, times: int, delay: float | None = None) -> Callable[[Callable[..., Any]], Callable[..., Any]]:
    """Decorate a test method: it is run up to `times` times, `delay` seconds apart, until no assertion fails."""
    assert times > 0

    def decorate(function: Callable[..., Any]) -> Callable[..., Any]:
        assert next(iter(inspect.signature(function).parameters), None) == "self"

        @functools.wraps(function)
        def wrapped(self: Any, *args: Any, **kwargs: Any) -> Any:
            for _ in range(times - 1):
                noted = [(each, len(each)) for each in _failures(self)]
                try:
                    result = function(self, *args, **kwargs)
                    if all(len(each) == length for each, length in noted):
                        return result
                except AssertionError:
                    pass  # the next try may do better; the last one is not caught
                for each, length in noted:
                    del each[length:]
                self._outcome.success = True
                if delay is not None:
                    time.sleep(delay)
            return function(self, *args, **kwargs)

        return wrapped

    return decorate


def _failures(test: Any) -> list[list[Any]]:
    """Return where unittest notes failed subtests: in a list of the outcome until Python 3.10, then in the result."""
    outcome = test._outcome
    return [outcome.errors] if hasattr(outcome, "errors") else [outcome.result.errors, outcome.result.failures]
