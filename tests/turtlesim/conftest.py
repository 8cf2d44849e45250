"""A machine whose time the test moves on: it starts turtlesim's executables and watches with a node of its own."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Any

import pytest

from tests.support.stepped_keyboard import Keyboard
from tests.support.stepped_machine import Running, SteppedMachine

TICK = 0.016


class Machine(SteppedMachine):
    def start(  # type: ignore[override]
        self, executable: str, *args: str, keyboard: Keyboard | None = None, screen: bool = False
    ) -> Running:
        """Run one of turtlesim's executables up to its first wait."""
        return super().start("turtlesim", executable, *args, stdin=keyboard, screen=screen)

    def ticks(self, count: int) -> None:
        self.advance(count * TICK)

    def wait(self, future: Any, seconds: float = 200 * TICK, step: float = TICK) -> Any:
        """Move on tick by tick until the future is done; return its result."""
        return super().wait(future, seconds, step)

    def topics(self) -> set[str]:
        return {name for name, _ in self.node.get_topic_names_and_types()}


@pytest.fixture
def machine() -> Iterator[Machine]:
    machine = Machine()
    yield machine
    machine.end()


@pytest.fixture
def keyboard() -> Keyboard:
    return Keyboard()
