"""A person at a console of Windows, where there are no pseudo-terminals: `typist.py` types, pyte shows what the program draws."""

from __future__ import annotations

import os
import subprocess
import sys
import threading
import time
from collections.abc import Callable, Mapping
from pathlib import Path

import pyte
import pytest

from tests.support.waiting import PATIENCE, until
from tests.windows import typist

COLUMNS, ROWS = 80, 24


class Console:
    """One program in a console of its own; used like `Terminal` of tests/e2e."""

    def __init__(self, command: list[str], cwd: Path, env: Mapping[str, str]) -> None:
        size = {"COLUMNS": str(COLUMNS), "LINES": str(ROWS), "PYTHONIOENCODING": "utf-8"}
        self._process = subprocess.Popen(
            [sys.executable, typist.__file__, *command],
            creationflags=subprocess.CREATE_NEW_CONSOLE,  # type: ignore[attr-defined]
            cwd=cwd,
            env={**env, **size},
            stdin=subprocess.PIPE,
            stdout=subprocess.PIPE,
        )
        self.output = bytearray()
        """All that the program has drawn."""
        self._screen = pyte.Screen(COLUMNS, ROWS)
        threading.Thread(target=self._read, daemon=True).start()

    def _read(self) -> None:
        assert self._process.stdout is not None
        stream = pyte.ByteStream(self._screen)
        while data := os.read(self._process.stdout.fileno(), 65536):
            self.output += data
            stream.feed(data)

    def __enter__(self) -> Console:
        return self

    def __exit__(self, *_: object) -> None:
        assert self._process.stdin is not None
        self._process.stdin.close()  # at which the typist ends the program
        try:
            self._process.wait(20)
        except subprocess.TimeoutExpired:
            self._process.kill()

    @property
    def status(self) -> int | None:
        """The program's, once it has ended."""
        status = self._process.poll()
        if status == typist.NO_KEYBOARD:
            pytest.skip("the console of Wine hears no keys without a display")
        return status

    def send(self, keys: str) -> None:
        """Type."""
        assert self._process.stdin is not None
        self._process.stdin.write(keys.encode())
        self._process.stdin.flush()

    def quit(self) -> None:
        """Ctrl-Q, and once more for the question whether to end what runs."""
        self.send("\x11\x11")

    def look(self, seconds: float = 0.0) -> str:
        """The screen as text, in `seconds`."""
        time.sleep(seconds)
        return "\n".join(line.rstrip() for line in self._screen.display)

    def columns_of(self, row: int) -> list[int]:
        """The column in which each character of a row stands."""
        cells = self._screen.buffer[row]
        return [column for column in range(COLUMNS) for _ in cells[column].data]

    def wait(self, *wanted: str, limit: float = PATIENCE) -> str:
        """Look until every text is on the screen, and return it."""
        self._until(lambda seen: all(text in seen for text in wanted), limit)
        return self.look()

    def wait_gone(self, *unwanted: str, limit: float = PATIENCE) -> None:
        """Look until none of the texts is on the screen."""
        self._until(lambda seen: not any(text in seen for text in unwanted), limit)

    def wait_end(self, limit: float = PATIENCE) -> int:
        """Wait until the program has ended by itself; returns its status."""
        until(lambda: self.status is not None, limit, every=0.05, told=self.look)
        return int(self._process.returncode)

    def _until(self, condition: Callable[[str], bool], limit: float) -> None:
        until(lambda: condition(self.look()) or self.status is not None, limit, every=0.05, told=self.look)
        assert condition(self.look()), f"ended with status {self.status}:\n{self.look()}"
