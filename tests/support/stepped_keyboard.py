"""A keyboard on which a test presses the keys."""

from __future__ import annotations

import contextlib
from collections import deque
from collections.abc import Iterator

from day6_core.session.streams import InputStream
from day6_core.session.task import Signal, wait_for


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
