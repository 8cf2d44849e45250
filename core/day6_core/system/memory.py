"""How much memory and how many processors this process may use: the machine's, or less where a control group allows less."""

from __future__ import annotations

import os
import sys
from collections.abc import Iterable
from functools import cache
from pathlib import Path
from typing import NamedTuple

from day6_core.system.control_groups import Tree, core_limits, memory_limits, read, trees


class Memory(NamedTuple):
    """Bytes: all that may be used, and how much of it is free."""

    total: int
    free: int


def available(found: Iterable[Tree] | None = None, meminfo: str | None = None) -> Memory | None:
    """Return what there is; None where the system doesn't say what is free (macOS, Windows)."""
    text = read(Path("/proc/meminfo")) if meminfo is None else meminfo
    lines = dict(line.split(":", 1) for line in text.splitlines() if ":" in line)
    try:
        total, free = (int(lines[name].split()[0]) << 10 for name in ("MemTotal", "MemAvailable"))
    except (ValueError, KeyError, IndexError):
        return None
    for each in memory_limits(trees() if found is None else found):
        total, free = min(total, each.most), min(free, max(0, each.most - each.used))
    return Memory(total, free)


@cache
def total_memory() -> int | None:
    """Return all that may be used, also where nobody says what is free; None where that isn't known either (Windows)."""
    if (found := available()) is not None:
        return found.total
    if sys.platform == "win32":
        return None
    try:
        return os.sysconf("SC_PAGE_SIZE") * os.sysconf("SC_PHYS_PAGES")
    except (OSError, ValueError):
        return None


def cores(found: Iterable[Tree] | None = None) -> float:
    """Return how many processors this process may fill at a time."""
    return min([float(processors()), *core_limits(trees() if found is None else found)])


def processors() -> int:
    """Return how many processors this process may run on."""
    if sys.platform == "linux":
        return len(os.sched_getaffinity(0))
    return os.cpu_count() or 1
