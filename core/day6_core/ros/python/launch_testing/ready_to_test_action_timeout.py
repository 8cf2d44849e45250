"""The decorator for launches that take long to be ready."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any, TypeVar

_Function = TypeVar("_Function", bound=Callable[..., Any])


def ready_to_test_action_timeout(timeout: float) -> Callable[[_Function], _Function]:
    """Decorate a `generate_test_description`: its `ReadyToTest` may take so many seconds, instead of 15."""

    def decorate(function: _Function) -> _Function:
        function.__ready_to_test_action_timeout__ = timeout  # type: ignore[attr-defined]
        return function

    return decorate
