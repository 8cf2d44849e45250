"""The decorator of tests for the time after the launch."""

from __future__ import annotations

from collections.abc import Callable
from typing import TypeVar

_Class = TypeVar("_Class", bound=type)


def post_shutdown_test() -> Callable[[_Class], _Class]:
    """Mark a test class whose tests run when all processes have ended. Raises TypeError for anything that isn't a class."""

    def decorate(test_item: _Class) -> _Class:
        if not isinstance(test_item, type):
            raise TypeError("postcondition_test should decorate test classes")
        test_item.__post_shutdown_test__ = True  # type: ignore[attr-defined]
        return test_item

    return decorate
