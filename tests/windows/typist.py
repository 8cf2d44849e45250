"""Types into a program that runs in a console of its own: typist.py PROGRAM…; `console.py` starts it.

Characters from standard input are put into the console's input as conhost does it for a program that wants control sequences: one
event for each, with no virtual key. Wine's console interprets no control sequences, so what the program draws goes to our own
standard output.
"""

from __future__ import annotations

import codecs
import ctypes
import os
import subprocess
import sys
import threading
import time
from ctypes import wintypes
from typing import Any

NO_KEYBOARD = 97
"""The status when the console takes no keys."""


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


def main(*program: str) -> None:
    """Type until the program ends; ends with its status."""
    kernel: Any = ctypes.windll.kernel32  # type: ignore[attr-defined]
    kernel.CreateFileW.restype = wintypes.HANDLE
    keyboard = wintypes.HANDLE(kernel.CreateFileW("CONIN$", 0xC0000000, 3, None, 3, 0, None))
    with open("CONIN$", encoding="utf-8") as console_in, open("CONOUT$", "w", encoding="utf-8") as console_out:
        running = subprocess.Popen(program, stdin=console_in, stdout=sys.stdout, stderr=console_out)
    threading.Thread(target=lambda: os._exit(running.wait()), daemon=True).start()
    decode = codecs.getincrementaldecoder("utf-8")().decode
    while data := os.read(0, 4096):
        for character in decode(data):
            event = _Key(1, True, 1, 0, 0, character, 0)
            if not kernel.WriteConsoleInputW(keyboard, ctypes.byref(event), 1, ctypes.byref(wintypes.DWORD())):
                running.kill()
                os._exit(NO_KEYBOARD)
            time.sleep(0.02)  # as a slow terminal does
    running.kill()


if __name__ == "__main__":
    main(*sys.argv[1:])
