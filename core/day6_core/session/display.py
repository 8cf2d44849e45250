"""Windows: a program opens one with its model, the desktop draws every window in the list.

Nothing is drawn here and nothing is posted anywhere. The desktop compares `Display.version` with the version it saw last and
reads `windows` again when it changed; it reads a window's content from the model whenever it draws a frame.
"""

from __future__ import annotations

import threading
from collections.abc import Callable
from typing import Generic, TypeVar

Model = TypeVar("Model", covariant=True)
"""The data behind a window. A window only passes it on, so a window of any model is a `Window[object]`."""

Opened = TypeVar("Opened")
"""The model of the window that `Display.open` returns."""


class Window(Generic[Model]):
    """One window of one program. `kind` names the drawing ('turtlesim', 'rqt_graph', …), `model` is the data it draws."""

    def __init__(self, display: Display, number: int, kind: str, title: str, model: Model) -> None:
        self.number = number
        """Unique for the life of the display."""
        self.kind = kind
        self.title = title
        self.model = model
        self.closed = False
        self.chosen = False
        """Whether a person has just asked for it, by its command or in another window, and so expects the keyboard in it."""
        self.command = 0
        """The pid of what was started to open it: of its program, or of the launch that runs its program."""
        self.is_launched = False
        """Whether that is a launch: its windows belong together."""
        self.on_close: Callable[[], None] | None = None
        """Called when the user closes the window (any thread); `Session.display` sets it to end the program."""
        self._display = display

    def close(self) -> None:
        """Close the window from the program."""
        self._display._remove(self)

    def close_by_user(self) -> None:
        """Close the window for the user: it disappears at once, then `on_close` is called."""
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
        self._windows: list[Window[object]] = []
        self._opened = 0
        self.version = 0
        """Grows whenever a window is opened or closed."""

    @property
    def windows(self) -> list[Window[object]]:
        """A copy of the list, oldest first."""
        with self._lock:
            return list(self._windows)

    def open(self, kind: str, title: str, model: Opened, *, chosen: bool = False) -> Window[Opened]:
        """Open a window with its model on top of the others and return it. For `chosen` see `Window`."""
        with self._lock:
            self._opened += 1
            window = Window(self, self._opened, kind, title, model)
            window.chosen = chosen
            self._windows.append(window)
            self.version += 1
            return window

    def _remove(self, window: Window[object]) -> None:
        with self._lock:
            window.closed = True
            if window in self._windows:
                self._windows.remove(window)
                self.version += 1


class ProgramDisplay(Display):
    """One program's view of a display: its windows are closed when it ends, and closing one interrupts it."""

    def __init__(self, display: Display, on_close: Callable[[], None], pid: int = 0) -> None:
        super().__init__()
        self._display = display
        self._on_close = on_close
        self._command = pid
        self._is_launched = False

    def belong_to(self, launch: int) -> None:
        """The program runs for the launch with this pid."""
        self._command, self._is_launched = launch, True

    def open(self, kind: str, title: str, model: Opened, *, chosen: bool = False) -> Window[Opened]:
        """Open a window on the machine's display; when the user closes it, the program is interrupted."""
        window = self._display.open(kind, title, model, chosen=chosen)
        window.command, window.is_launched = self._command, self._is_launched
        window.on_close = self._on_close
        with self._lock:
            self._windows.append(window)
        return window

    def close(self) -> None:
        """Close all windows of the program."""
        for window in self.windows:
            window.close()
