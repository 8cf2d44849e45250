"""Plays a person at the desktop, in a console of its own: typist.py ANSWER HOME [KEYS…] writes a JSON file.

The console is Windows', or Wine's, which interprets no control sequences: what is drawn goes into a pipe and to pyte. Keys are
put into the console's input as conhost does it for a program that wants control sequences: one event for each character, with no
virtual key.
"""

from __future__ import annotations

import ctypes
import json
import os
import subprocess
import sys
import threading
import time
from ctypes import wintypes
from pathlib import Path
from typing import Any

import pyte

COLUMNS, ROWS = 100, 30
QUIET = 3.0
"""Seconds without output after which a picture is complete."""


class _Key(ctypes.Structure):
    """KEY_EVENT_RECORD in an INPUT_RECORD."""

    _fields_ = [
        ("type", wintypes.WORD),
        ("down", wintypes.BOOL),
        ("count", wintypes.WORD),
        ("virtual_key", wintypes.WORD),
        ("scan_code", wintypes.WORD),
        ("character", wintypes.WCHAR),
        ("modifiers", wintypes.DWORD),
    ]


class Typist:
    """A desktop that runs, its screen, and its keyboard."""

    def __init__(self, home: str) -> None:
        self._kernel: Any = ctypes.windll.kernel32  # type: ignore[attr-defined]
        self._kernel.CreateFileW.restype = wintypes.HANDLE
        self._keyboard = wintypes.HANDLE(self._kernel.CreateFileW("CONIN$", 0xC0000000, 3, None, 3, 0, None))
        size = {"COLUMNS": str(COLUMNS), "LINES": str(ROWS)}
        self.desktop = subprocess.Popen(
            [sys.executable, "-m", "day6_tui.main", "--home", home, "--lang", "en"],
            stdin=open("CONIN$", encoding="utf-8"),  # noqa: SIM115  # as long as the desktop, as the next
            stdout=subprocess.PIPE,
            stderr=open("CONOUT$", "w", encoding="utf-8"),  # noqa: SIM115
            env={**os.environ, **size, "PYTHONIOENCODING": "utf-8", "DAY6_LINK": "off"},
        )
        self._screen = pyte.Screen(COLUMNS, ROWS)
        self._heard = time.monotonic()
        threading.Thread(target=self._read, daemon=True).start()

    def _read(self) -> None:
        assert self.desktop.stdout is not None
        stream = pyte.ByteStream(self._screen)
        while data := os.read(self.desktop.stdout.fileno(), 65536):
            stream.feed(data)
            self._heard = time.monotonic()

    def screen(self) -> str:
        """Return what stands on the screen when nothing more comes."""
        while self.desktop.poll() is None and time.monotonic() - self._heard < QUIET:
            time.sleep(0.1)
        return "\n".join(self._screen.display)

    def type(self, keys: str) -> None:
        """Give it the characters one by one, as a slow terminal does. OSError if the console has no keyboard."""
        for character in keys:
            event = _Key(1, True, 1, 0, 0, character, 0)
            if not self._kernel.WriteConsoleInputW(
                self._keyboard, ctypes.byref(event), 1, ctypes.byref(wintypes.DWORD())
            ):
                raise OSError("no keyboard")
            time.sleep(0.02)
        self._heard = time.monotonic()


def main(answer: str, home: str, *keys: str) -> None:
    """Write what stands on the screen at first and after each of the keys, and the status with which the desktop ended."""
    typist = Typist(home)
    deadline = time.monotonic() + 120
    while "$" not in (screen := typist.screen()) and typist.desktop.poll() is None and time.monotonic() < deadline:
        time.sleep(0.5)
    screens = [screen]
    try:
        for each in keys:
            typist.type(each)
            screens.append(typist.screen())
    except OSError:
        typist.desktop.kill()
    try:
        status = typist.desktop.wait(60)
    except subprocess.TimeoutExpired:
        typist.desktop.kill()
        status = None
    Path(answer).write_text(json.dumps([screens, status]), encoding="utf-8")


if __name__ == "__main__":
    main(*sys.argv[1:])
