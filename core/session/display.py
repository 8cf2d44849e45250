"""Windows: a program opens one with its model, the desktop draws what it finds in the list.

Nothing is drawn here and nothing is posted anywhere. The desktop compares `Display.version` with what it saw last and reads
`windows` again when it changed; a window's content it reads from the model whenever it draws a frame.
"""

from __future__ import annotations

import threading
from collections.abc import Callable
from typing import Any


class Window:
    """One window of one program. `kind` names the drawing ('turtlesim', 'rqt_graph', …), `model` is what it draws."""

    def __init__(self, display: Display, number: int, kind: str, title: str, model: Any) -> None:
        self.number = number
        """Unique for the life of the display."""
        self.kind = kind
        self.title = title
        self.model = model
        self.closed = False
        self.on_close: Callable[[], None] | None = None
        """What happens when the user closes the window (any thread); `Session.display` sets it to end the program."""
        self._display = display

    def close(self) -> None:
        """The program takes its window away."""
        self._display._remove(self)

    def close_by_user(self) -> None:
        """The user closed the window: it goes at once, then its program is told."""
        if not self.closed:
            self._display._remove(self)
            if self.on_close is not None:
                self.on_close()

    def __repr__(self) -> str:
        return f"<Window {self.number} {self.kind} {self.title!r}>"


class Display:
    """The screen of the simulated machine: the windows that are open, oldest first. Any thread may call anything."""

    def __init__(self) -> None:
        self._lock = threading.Lock()
        self._windows: list[Window] = []
        self._opened = 0
        self.version = 0
        """Grows whenever a window came or went."""

    @property
    def windows(self) -> list[Window]:
        """A copy of the list, oldest first."""
        with self._lock:
            return list(self._windows)

    def open(self, kind: str, title: str, model: Any) -> Window:
        with self._lock:
            self._opened += 1
            window = Window(self, self._opened, kind, title, model)
            self._windows.append(window)
            self.version += 1
            return window

    def _remove(self, window: Window) -> None:
        with self._lock:
            window.closed = True
            if window in self._windows:
                self._windows.remove(window)
                self.version += 1


class ProgramDisplay(Display):
    """A display as one program sees it: its windows vanish with it, and closing one interrupts it."""

    def __init__(self, display: Display, on_close: Callable[[], None]) -> None:
        super().__init__()
        self._display = display
        self._on_close = on_close

    def open(self, kind: str, title: str, model: Any) -> Window:
        window = self._display.open(kind, title, model)
        window.on_close = self._on_close
        with self._lock:
            self._windows.append(window)
        return window

    def close(self) -> None:
        for window in self.windows:
            window.close()
