"""The command line that the system shows of this process, which can be written anew: a fork has its parent's.

Linux shows the memory in which the kernel put the words; they can be no longer than those the process was started with. The cell
of a process is found by these words (`left.marked`).
"""

from __future__ import annotations

import ctypes
import os
import sys
from typing import TYPE_CHECKING

from day6_core.system.processes import stat_fields

assert not TYPE_CHECKING or sys.platform == "linux"

_BEGIN, _END = 48 - 3, 49 - 3
"""Fields of /proc/PID/stat, by proc(5), after the name and the state before it."""


class ShownWords:
    """Where the words are. Make it in the parent: later the memory is found less easily."""

    def __init__(self) -> None:
        fields = stat_fields("self")
        self._begin, self._room = int(fields[_BEGIN]), int(fields[_END]) - int(fields[_BEGIN])
        self._used = self._room

    def show(self, argv: list[str]) -> None:
        """Show these words. Raises ValueError if there is no room for them."""
        data = b"\0".join(map(os.fsencode, argv)) + b"\0"
        if len(data) > self._room:
            raise ValueError(f"{len(data)} bytes of words, room for {self._room}")
        ctypes.memset(self._begin, 0, self._used)
        ctypes.memmove(self._begin, data, len(data))
        self._used = len(data)
