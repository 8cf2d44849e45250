"""What the processes of a world in virtual time and its coordinator tell each other: frames of one size over a Unix socket.

A frame is a kind, flags and two numbers. There are thousands a second, so they are plain tuples and plain integers.
"""

from __future__ import annotations

from struct import Struct

NEVER = -1
"""In place of a time."""
SENT_BY_SYSTEM = 0
"""In place of a signal's number: the system has sent one, perhaps, and Python has yet to see it."""

_FRAME = Struct("<BBqq")
SIZE = _FRAME.size
packed = _FRAME.pack
"""Return the bytes of a frame: kind, flags, first and second number."""
unpacked = _FRAME.unpack
"""Return what was packed."""


class Kind:
    """The kinds of frames, and what their two numbers are."""

    IDLE = 2
    """All its threads wait: its time, and until when it waits, or NEVER. With flags."""
    TOUCHED = 3
    """It has sent something to a process: its number."""
    SPAWNED = 4
    """It has started a process: its number."""
    KILLED = 5
    """It has sent a signal to a process, or to a group if the first number is negative; the second is the signal's."""
    WANTS = 6
    """Something has come from outside while it was idle."""
    GO = 7
    """It may go on: the time, and the process's number in the world. With flags."""
    SIGNAL = 8
    """Before GO: a signal for it, its number; or SENT_BY_SYSTEM."""
    SLEEP = 9
    """Nothing will happen before something comes from outside: it has to watch its own descriptors."""

    TYPED = 10
    """It has typed something in the terminal of a group of processes: its number."""


class Flag:
    """What a process tells of itself when it is idle, and is told when it goes on."""

    RAN = 1
    """It did something since it was last idle, so others may find something in their descriptors."""
    WATCHES = 2
    """It waits for descriptors of which nobody tells it when something comes."""
    HOLDS = 4
    """It waits for something from outside, as long as it takes: time stands still."""
    TOUCHED = 8
    """Something has been sent to it."""
