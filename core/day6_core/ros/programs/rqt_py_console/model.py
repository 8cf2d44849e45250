"""What the Python console of rqt shows: lines of Python, what they print, and what its interpreter waits for."""

from __future__ import annotations

import re
from collections import deque
from collections.abc import Callable

from day6_core.ros.programs.rqt_py_common.command_lines import CommandLines, Kind
from day6_core.ros.programs.rqt_py_console.interpreter import AWAITS, ERROR, PLAIN

NO_DESKTOP = "py_console.no_desktop"
"""The remark where Python cannot be run."""

MOST_WAITING = 10_000
"""Lines that were typed or pasted before the interpreter asks for them."""

_MARKS = re.compile(f"([{AWAITS}{ERROR}{PLAIN}])")


class PyConsole(CommandLines):
    """The model of one console. The window reads what is public and calls `run`, `interrupt`, `end_input` and `begin`."""

    def __init__(self) -> None:
        super().__init__()
        self._prompt: str | None = None
        self._kind = Kind.OUTPUT
        self._waiting: deque[str] = deque(maxlen=MOST_WAITING)
        self._send: Callable[[str], object] | None = None
        self._interrupt: Callable[[], object] | None = None
        self.status: int | None = None
        """That of the last interpreter; None while one runs, and where there can be none."""
        self.on_begin: Callable[[], object] | None = None
        """Called (any thread) when another interpreter is wanted."""

    # -- the window's side ---------------------------------------------------------------------------------------------

    @property
    def prompt(self) -> str | None:
        return self._prompt

    @property
    def can_interrupt(self) -> bool:
        return self._interrupt is not None

    def run(self, line: str) -> bool:
        """Give the interpreter a line, now or when it asks for one; False if there is no interpreter."""
        with self._lock:
            if self._send is None:
                return False
            if line.strip() and (not self.history or self.history[-1] != line):
                self.history.append(line)
            self._waiting.append(line)
            self._send_next()
            return True

    def interrupt(self) -> None:
        """Raise KeyboardInterrupt in what runs; lines that wait are dropped, as by a terminal."""
        with self._lock:
            self._waiting.clear()
            if self._interrupt is not None:
                self._interrupt()

    def end_input(self) -> None:
        """Ctrl-D: the interpreter reads no more, which ends it."""
        with self._lock:
            if self._send is not None:
                self._send("")

    def begin(self) -> None:
        """Begin with another interpreter."""
        if self.status is not None and self.on_begin is not None:
            self.on_begin()

    # -- the program's side --------------------------------------------------------------------------------------------

    def began(self, send: Callable[[str], object], interrupt: Callable[[], object]) -> None:
        """An interpreter runs: `send` gets what it reads ('' for the end), `interrupt` is its Ctrl-C."""
        with self._lock:
            self._send, self._interrupt = send, interrupt
            self._kind, self.status = Kind.OUTPUT, None
            self.version += 1

    def ended(self, status: int | None) -> None:
        """The interpreter has ended; None if there can be no other."""
        with self._lock:
            self._send = self._interrupt = self._prompt = self._open = None
            self._waiting.clear()
            self.status = status
            self.version += 1

    def take_stream(self, text: str) -> None:
        """Take what the interpreter has printed, with its marks."""
        with self._lock:
            for piece in _MARKS.split(text):
                if piece == AWAITS:
                    self._await()
                elif piece in (ERROR, PLAIN):
                    self._kind = Kind.ERROR if piece == ERROR else Kind.OUTPUT
                elif piece:
                    self.take(piece, self._kind)

    def _await(self) -> None:
        """A line is read: the unfinished one is its prompt."""
        self._prompt = ""
        if self._open is not None and self._lines:
            self._prompt = self._lines.pop()[1]
            self._open = None
        self.version += 1
        self._send_next()

    def _send_next(self) -> None:
        if self._prompt is not None and self._waiting and self._send is not None:
            line = self._waiting.popleft()
            self._show_command(self._prompt + line)
            self._prompt = None
            self._send(f"{line}\n")
