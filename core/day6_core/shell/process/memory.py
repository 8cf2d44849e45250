"""The memory limit of a student's process: it gets a MemoryError before the machine grinds to a halt."""

from __future__ import annotations

import os
import sys
from functools import cache

VARIABLE = "DAY6_MEMORY_LIMIT"
"""Megabytes for each process; 0 sets no limit."""
SHARE = 0.6
"""The share of the machine's memory, unless VARIABLE sets a limit."""
LEAST = 1024 * 2**20
_CONTROL_GROUP = "/sys/fs/cgroup/memory.max"


def memory_limit() -> int:
    """Return the bytes of data that a process may have, 0 for no limit (also if the system cannot limit it)."""
    setting = os.environ.get(VARIABLE, "").strip()
    if setting.isdigit():
        return int(setting) * 2**20
    machine = machine_memory()
    return max(LEAST, int(machine * SHARE)) if machine else 0


@cache
def machine_memory() -> int:
    """Return the bytes of memory of the machine, or of our container; 0 if unknown."""
    if sys.platform == "win32":
        return 0
    try:
        found = os.sysconf("SC_PAGE_SIZE") * os.sysconf("SC_PHYS_PAGES")
    except (OSError, ValueError):
        return 0
    try:
        with open(_CONTROL_GROUP, encoding="ascii") as file:
            allowed = file.read().strip()
    except OSError:
        return found
    return min(found, int(allowed)) if allowed.isdigit() else found
