"""Conditions under which actions are executed."""

from __future__ import annotations

from collections.abc import Callable
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from launch.launch_context import LaunchContext


class Condition:
    """A condition that holds if `predicate(context)` is true; without a predicate it never holds."""

    def __init__(self, *, predicate: Callable[[LaunchContext], bool] | None = None) -> None:
        self._predicate = predicate

    def describe(self) -> str:
        return self.__repr__()

    def evaluate(self, context: LaunchContext) -> bool:
        """Return whether it holds now."""
        return self._predicate is not None and self._predicate(context)
