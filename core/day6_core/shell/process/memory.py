"""The memory limit of a student's process: it gets a MemoryError before the machine grinds to a halt."""

from __future__ import annotations

import os
import sys

from day6_core.system.memory import total_memory

VARIABLE = "DAY6_MEMORY_LIMIT"
"""Megabytes for each process; 0 sets no limit."""
SHARE = 0.6
"""The share of the machine's memory, unless VARIABLE sets a limit."""
LEAST = 1024 * 2**20


def is_held_by_system() -> bool:
    """Whether the system holds a process to a limit of its data (RLIMIT_DATA); else `memory_watch` looks after it."""
    return sys.platform == "linux"


def memory_limit() -> int:
    """Return the bytes of data that a process may have, 0 for no limit."""
    setting = os.environ.get(VARIABLE, "").strip()
    if setting.isdigit():
        return int(setting) * 2**20
    total = total_memory()
    return max(LEAST, int(total * SHARE)) if total else 0
