"""For how many desktops this machine has room, and why not for more: what docs/en/teachers/jupyterhub.md computes by hand."""

from __future__ import annotations

import contextlib
from collections.abc import Sequence
from pathlib import Path
from typing import NamedTuple

from day6_core.isolation.cell import Phrase
from day6_core.system.memory import Memory
from day6_core.whole_file import write_private

DESKTOP = 62 << 20
"""Bytes that a desktop takes as long as none was measured here."""
PROGRAMS = 110 << 20
"""Bytes that are kept for the programs that a pupil starts."""
CORE = 0.029
"""What a pupil takes of a core, half of them driving a robot, as it was measured for the documentation."""
FULL_MEMORY, FULL_CORES = 0.8, 0.7
"""What is filled: the rest is for everything else that runs here, and for the moments in which all want something."""

_FILE = "desktop-memory"
_LEAST, _MOST = 10 << 20, 4 << 30
"""Bytes that can be what one desktop takes; anything else in the file is not."""


class Room(NamedTuple):
    """So many desktops, and what keeps more from fitting."""

    desktops: int
    why: Phrase


def room(memory: Memory | None, cores: float, running: Sequence[int], desktop: int | None, most: int) -> Room:
    """Compute it, from the memory that is free now and that the running ones take.

    `desktop` is what one takes, None if that was never measured; `most` is how many the server lets run.
    """
    limits = [Room(most, Phrase("serve.room.most", {"most": str(most)})), _by_cores(cores)]
    limits += [] if memory is None else [_by_memory(memory, sum(running), desktop)]
    return min(limits, key=lambda each: each.desktops)


def _by_cores(cores: float) -> Room:
    return Room(int(cores * FULL_CORES / CORE), Phrase("serve.room.cores", {"cores": f"{cores:g}"}))


def _by_memory(memory: Memory, running: int, desktop: int | None) -> Room:
    each = (desktop or DESKTOP) + PROGRAMS
    for_all = memory.free + running - memory.total * (1 - FULL_MEMORY)
    values = {"desktop": (desktop or DESKTOP) >> 20, "programs": PROGRAMS >> 20, "free": memory.free >> 20}
    key = "serve.room.memory" if desktop else "serve.room.memory.unmeasured"
    return Room(max(0, int(for_all // each)), Phrase(key, {name: str(value) for name, value in values.items()}))


def remembered(folder: Path) -> int | None:
    """Return what a desktop took here when it was last measured; None if it never was."""
    with contextlib.suppress(OSError, ValueError):
        with open(folder / _FILE, encoding="ascii") as file:
            found = int(file.read(20))
        return found if _LEAST <= found <= _MOST else None
    return None


def remember(folder: Path, desktop: int) -> None:
    """Keep that for the next server. Raises OSError."""
    write_private(folder / _FILE, f"{desktop}\n".encode())
