"""What the system shows of a process: its words and variables."""

from __future__ import annotations

import sys

if sys.platform != "linux":
    raise ImportError("there is no virtual time on this system")

import ctypes
import os
from collections.abc import Iterable, Mapping

from day6_core.system.processes import stat_fields

_BEGIN_OF_WORDS, _BEGIN_OF_VARIABLES = 45, 47
"""Where `stat_fields` has it; the end is behind it."""


def show(words: Iterable[str], variables: Mapping[str, str]) -> None:
    """Have the system show others in the place of the first ones, as far as there is room: short variables first."""
    for name, value in os.environ.items():
        os.putenv(name, value)  # or this process's own would be gone, too
    fields = stat_fields("self")
    short_first = sorted(map("=".join, variables.items()), key=len)
    for texts, at in ((words, _BEGIN_OF_WORDS), (short_first, _BEGIN_OF_VARIABLES)):
        begin, end = int(fields[at]), int(fields[at + 1])
        if end <= begin:
            continue  # a system that doesn't say where they are
        data = b"".join(os.fsencode(text) + b"\0" for text in texts)[: end - begin - 1]
        ctypes.memset(begin, 0, end - begin)
        ctypes.memmove(begin, data, len(data))
