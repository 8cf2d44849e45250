"""What the shell of rqt shows: command lines and what they print. With Qt 5 the real one has no other shell than this.

Its own words for it (shell.py): "Simple shell for executing non-interactive finite commands."
"""

from __future__ import annotations

from collections import deque
from collections.abc import Callable
from enum import Enum

MOST_LINES = 2_000
MOST_CHARACTERS = 2_000
"""Of one line; the rest is cut off."""

PROMPT = ">>> "
"""qt_gui_py_common, console_text_edit.py"""


class Kind(Enum):
    """What a line is."""

    COMMAND = "command"
    OUTPUT = "output"
    ERROR = "error"
    REMARK = "remark"
    """A sentence of ours, which the window has in the user's language; the line is its name."""


NO_DESKTOP = "shell.no_desktop"
"""The remark where commands cannot be run."""


class Shell:
    """The model of one shell. The window reads `lines`, `running`, `version`, and calls `run` and `interrupt`."""

    def __init__(self) -> None:
        self._lines: deque[tuple[Kind, str]] = deque(maxlen=MOST_LINES)
        self._open: Kind | None = None
        """The kind of the last line while it has no end."""
        self.running = ""
        """The command line that runs; '' for none."""
        self.history: list[str] = []
        self.version = 0
        self.on_run: Callable[[str], object] | None = None
        """Called (any thread) with a line that is to be run."""
        self.on_interrupt: Callable[[], object] | None = None
        """Called (any thread) to end the command that runs."""

    @property
    def lines(self) -> list[tuple[Kind, str]]:
        """What there is to see, the oldest first."""
        return list(self._lines)

    def run(self, line: str) -> bool:
        """Run a command line; False while another one runs, or for an empty one."""
        if self.running or not line.strip():
            return False
        self.running = line
        self.history.append(line)
        self._lines.append((Kind.COMMAND, PROMPT + line))
        self._open = None
        self.version += 1
        if self.on_run is not None:
            self.on_run(line)
        return True

    def interrupt(self) -> None:
        """End the command that runs."""
        if self.on_interrupt is not None:
            self.on_interrupt()

    def take(self, text: str, kind: Kind) -> None:
        """Add text that was printed."""
        pieces = text.split("\n")
        if self._open is kind and self._lines:
            _, before = self._lines.pop()
            pieces[0] = before + pieces[0]
        self._open = kind if pieces[-1] else None
        for piece in pieces if pieces[-1] else pieces[:-1]:
            self._lines.append((kind, piece[:MOST_CHARACTERS]))
        self.version += 1

    def ended(self) -> None:
        """The command has ended."""
        self.running, self._open = "", None
        self.version += 1
