"""What a person is told about the link: its doors to other machines, and what came from others and was not taken.

Plain data. The process with the doors writes theirs into the meeting place, where the user's other processes read them.
"""

from __future__ import annotations

import json
import os
from collections.abc import Mapping
from contextlib import suppress
from enum import Enum
from pathlib import Path
from types import MappingProxyType
from typing import NamedTuple

from day6_tui.core.link.paths import Place, process_exists

_PREFIX = "doors-"
_LONGEST_FILE = 65536


class DoorState(str, Enum):
    """How it stands with one endpoint of `--listen` or `--connect`."""

    OPENING = "opening"
    OPEN = "open"
    """Listening, or connected."""
    IN_USE = "in use"
    """Another program listens on this port."""
    NO_NAME = "no name"
    """Nobody knows the host's name."""
    NOBODY = "nobody"
    """The machine is there, but no program listens on that port."""
    NO_ANSWER = "no answer"
    NOT_LET_IN = "not let in"
    """A program answers there, but it does not let us in: another secret, or no Zenoh."""
    FAILED = "failed"
    """For a reason of the system's."""


class Door(NamedTuple):
    """One endpoint of `--listen` (`listening`) or `--connect`; `joined` counts the machines that came in by it."""

    endpoint: str
    listening: bool
    state: DoorState = DoorState.OPENING
    secret: bool = False
    """Whether a secret is asked for."""
    joined: int = 0
    reason: str = ""
    """The system's words, with FAILED."""


class LinkState(NamedTuple):
    """`problem` says why there is no link; `refused` counts what was not taken, by the names of `limits`."""

    problem: str | None = None
    doors: tuple[Door, ...] = ()
    refused: Mapping[str, int] = MappingProxyType({})
    passed_over: tuple[str, ...] = ()
    """Why the processes of this user do not meet in the usual folder."""


def write_doors(place: Place, doors: tuple[Door, ...]) -> None:
    """Let the user's other processes know of this process's doors. Raises OSError."""
    path = _file(place)
    new = path.with_name(f"new-{path.name}")
    descriptor = os.open(new, os.O_WRONLY | os.O_CREAT | os.O_TRUNC, 0o600)
    with os.fdopen(descriptor, "w", encoding="utf-8") as file:
        json.dump([[*door] for door in doors], file)
    os.replace(new, path)


def remove_doors(place: Place) -> None:
    """Take back what `write_doors` wrote."""
    with suppress(OSError):
        _file(place).unlink(missing_ok=True)


def read_doors(place: Place) -> tuple[Door, ...]:
    """Return the doors of all this user's processes of a domain; what a killed process left is removed."""
    found: list[Door] = []
    with suppress(OSError):
        for name in sorted(os.listdir(place.folder)):
            if not name.startswith(_PREFIX):
                continue
            path = place.folder / name
            if not process_exists(int(name.removeprefix(_PREFIX))):
                path.unlink(missing_ok=True)
                continue
            found += _read(path)
    return tuple(found)


def _file(place: Place) -> Path:
    return place.folder / f"{_PREFIX}{os.getpid()}"


def _read(path: Path) -> list[Door]:
    with path.open(encoding="utf-8") as file:
        rows = json.loads(file.read(_LONGEST_FILE))
    return [
        Door(endpoint, listening, DoorState(state), secret, joined, reason)
        for endpoint, listening, state, secret, joined, reason in rows
    ]
