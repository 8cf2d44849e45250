"""What processes take of the machine, by their command lines."""

from __future__ import annotations

import os
from pathlib import Path


def cpu_of(marks: tuple[bytes, ...]) -> dict[str, float]:
    """Seconds of CPU that processes have taken, by what their command lines hold."""
    taken = dict.fromkeys(map(os.fsdecode, marks), 0.0)
    for name in filter(str.isdigit, os.listdir("/proc")):
        try:
            words = Path("/proc", name, "cmdline").read_bytes()
            fields = (
                Path("/proc", name, "stat").read_text(encoding="ascii", errors="replace").rpartition(")")[2].split()
            )
        except OSError:
            continue
        for mark in marks:
            if mark in words:
                taken[os.fsdecode(mark)] += (int(fields[11]) + int(fields[12])) / os.sysconf("SC_CLK_TCK")
                break
    return taken
