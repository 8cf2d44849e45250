"""What the processes of a world in virtual time and its coordinator tell each other: frames of one size over a Unix socket."""

from __future__ import annotations

from enum import IntEnum, IntFlag
from struct import Struct
from typing import NamedTuple

NEVER = -1
"""In place of a time."""

_FRAME = Struct("<BBqq")
SIZE = _FRAME.size


class Kind(IntEnum):
    """The kinds of frames, and what their two numbers are."""

    HELLO = 1
    """A process takes part: its number."""
    IDLE = 2
    """All its threads wait: its time, and until when it waits, or NEVER. With flags."""
    TOUCHED = 3
    """It has sent something to a process: its number."""
    SPAWNED = 4
    """It has started a process: its number."""
    KILLED = 5
    """It has sent a signal to a process: the process's number and the signal's."""
    WANTS = 6
    """Something has come from outside while it was idle."""
    GO = 7
    """It may go on: the time."""
    SIGNAL = 8
    """Before GO: a signal for it, its number."""
    SLEEP = 9
    """Nothing will happen before something comes from outside: it has to watch its own descriptors."""


class Flag(IntFlag):
    """What a process tells of itself when it is idle."""

    RAN = 1
    """It did something since it was last idle, so others may find something in their descriptors."""
    WATCHES = 2
    """It waits for descriptors of which nobody tells it when something comes."""
    HOLDS = 4
    """It waits for something from outside, as long as it takes: time stands still."""


class Frame(NamedTuple):
    """One frame."""

    kind: int
    flags: int = 0
    first: int = 0
    second: int = 0

    def packed(self) -> bytes:
        """Return its bytes."""
        return _FRAME.pack(*self)

    @classmethod
    def unpacked(cls, data: bytes) -> Frame:
        """Return the frame of SIZE bytes."""
        return cls(*_FRAME.unpack(data))
