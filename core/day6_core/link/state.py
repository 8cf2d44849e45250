"""The link's state as shown to people: its doors to other machines, and counts of what was refused.

Plain data. The process with the doors writes their state into the meeting place, where the user's other processes read it.
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

from day6_core.link.paths import MeetingPlace, process_exists
from day6_core.whole_file import PRIVATE, replace_file

_PREFIX = "doors-"
_LONGEST_FILE = 65536


class DoorState(str, Enum):
    """The state of one endpoint of `--listen` or `--connect`."""

    OPENING = "opening"
    OPEN = "open"
    """Listening, or connected."""
    IN_USE = "in use"
    """Another program listens on this port."""
    NO_NAME = "no name"
    """The host name cannot be resolved."""
    NOBODY = "nobody"
    """The machine answers, but no program listens on that port."""
    NO_ANSWER = "no answer"
    NOT_LET_IN = "not let in"
    """A program answers, but rejects us: its secret differs, or it is not Zenoh."""
    NO_CLASS = "no class"
    """Connected, but no teacher answers there."""
    NAME_TAKEN = "name taken"
    """Somebody else in the class has this pupil's name."""
    NAME_ALIKE = "name alike"
    """Somebody else in the class has a name that looks like this pupil's."""
    CLASS_FULL = "class full"
    OTHER_DOMAIN = "other domain"
    """A room has one graph, and this machine's ROS_DOMAIN_ID is not that of the room."""
    FAILED = "failed"
    """For a reason given by the operating system."""


class Door(NamedTuple):
    """One endpoint of `--listen` (`listening`) or `--connect`; `joined` is the number of machines connected by it."""

    endpoint: str
    listening: bool
    state: DoorState = DoorState.OPENING
    secret: bool = False
    """Whether a secret is required."""
    joined: int = 0
    reason: str = ""
    """The operating system's message, if FAILED."""
    is_class: bool = False
    """Whether only a class can join, whose pupils do not reach each other."""


class LinkState(NamedTuple):
    """`problem` is the reason if there is no link; `refused` counts refusals by the reasons given to `limits.Refusals`."""

    problem: str | None = None
    doors: tuple[Door, ...] = ()
    refused: Mapping[str, int] = MappingProxyType({})
    passed_over: tuple[str, ...] = ()
    """The reasons why the processes of this user do not meet in the usual folder."""
    with_zenoh: int = 0
    """Processes of this user and domain that this one cannot see, because they use Zenoh and it doesn't."""


def write_doors(place: MeetingPlace, doors: tuple[Door, ...]) -> None:
    """Publish this process's doors to the user's other processes.

    Raises:
        OSError: the file cannot be written.
    """
    text = json.dumps([[*door] for door in doors])
    replace_file(_file(place), text.encode("utf-8"), mode=PRIVATE, sync=False, follow=False)


def remove_doors(place: MeetingPlace) -> None:
    """Remove the file of `write_doors`."""
    with suppress(OSError):
        _file(place).unlink()


def read_doors(place: MeetingPlace) -> tuple[Door, ...]:
    """Return the doors of all this user's processes in a domain; files of killed processes are removed."""
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


def _file(place: MeetingPlace) -> Path:
    return place.folder / f"{_PREFIX}{os.getpid()}"


def _read(path: Path) -> list[Door]:
    with path.open(encoding="utf-8") as file:
        rows = json.loads(file.read(_LONGEST_FILE))
    return [
        Door(endpoint, listening, DoorState(state), *rest)  # another version's may have fewer fields
        for endpoint, listening, state, *rest in rows
    ]
