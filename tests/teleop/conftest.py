"""A machine whose time the test moves on, and a keyboard."""

from __future__ import annotations

import contextlib
import sys
from collections import deque
from collections.abc import Iterator
from pathlib import Path

import pytest

from day6_tui.core.session.streams import InputStream
from day6_tui.core.session.task import Signal, wait_for

sys.path.insert(0, str(Path(__file__).parents[1] / "stepped"))

from stepped_machine import SteppedMachine


class Keyboard(InputStream):
    """A terminal's keys."""

    def __init__(self) -> None:
        self._keys: deque[str] = deque()
        self._pressed = Signal()
        self.is_raw = False

    def isatty(self) -> bool:
        return True

    def press(self, *keys: str) -> None:
        self._keys.extend(keys)
        self._pressed.set()

    async def read_key(self) -> str:
        while not self._keys:
            self._pressed.clear()
            await wait_for(self._pressed)
        return self._keys.popleft()

    @contextlib.contextmanager
    def raw(self, *, signals: bool = True) -> Iterator[None]:
        assert signals, "Ctrl-C must stay Ctrl-C"
        self.is_raw = True
        try:
            yield
        finally:
            self.is_raw = False


@pytest.fixture
def machine() -> Iterator[SteppedMachine]:
    machine = SteppedMachine()
    yield machine
    machine.end()


@pytest.fixture
def keyboard() -> Keyboard:
    return Keyboard()
