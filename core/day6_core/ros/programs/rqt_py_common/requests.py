"""What a plugin's window wants: noted on any thread, done on the program's."""

from __future__ import annotations

from collections import deque
from collections.abc import Callable


class Requests:
    """The requests of a window, in their order. `on_request` is called on the thread that makes one."""

    def __init__(self) -> None:
        self._waiting: deque[Callable[[], object]] = deque()
        self.on_request: Callable[[], None] | None = None

    def post(self, request: Callable[[], object]) -> None:
        """Note a request (any thread)."""
        self._waiting.append(request)
        if self.on_request is not None:
            self.on_request()

    def handle(self) -> None:
        """Do what is wanted."""
        while self._waiting:
            self._waiting.popleft()()
