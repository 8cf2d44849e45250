"""The action that starts the tests."""

from __future__ import annotations

import logging
from collections.abc import Callable
from typing import TYPE_CHECKING, Any

from launch.action import Action

if TYPE_CHECKING:
    from launch.launch_context import LaunchContext

_logger = logging.getLogger(__name__)


class ReadyToTest(Action):
    """Says that what is tested is up: the tests begin when this action is executed."""

    def __init__(self, **kwargs: Any) -> None:
        super().__init__(**kwargs)
        self._callbacks: list[Callable[[], object]] = []

    def _add_callback(self, callback: Callable[[], object]) -> None:
        self._callbacks.append(callback)

    def execute(self, context: LaunchContext) -> None:
        for callback in self._callbacks:
            try:
                callback()
            except Exception as error:  # a test that cannot begin must not end the launch: its time runs out
                _logger.error(error)
