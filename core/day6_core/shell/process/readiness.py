"""Waits until a descriptor can be read or written, whatever its number: `select` knows none above 1023."""

from __future__ import annotations

import select
import sys


def has_output(fd: int, seconds: float | None) -> bool:
    """Return whether something, or the end, can be read within so many seconds (None: as long as it takes)."""
    if sys.platform == "win32":
        return True  # nobody can tell; reading waits
    if sys.platform == "darwin":  # its poll() knows no terminals
        return bool(select.select([fd], [], [], seconds)[0])
    return _polled(fd, select.POLLIN, seconds)


def has_room(fd: int, seconds: float) -> bool:
    """Return whether something can be written within so many seconds, or never any more."""
    if sys.platform == "win32":
        return True
    if sys.platform == "darwin":
        try:
            return bool(select.select([], [fd], [], seconds)[1])
        except OSError:
            return True  # closed meanwhile
    return _polled(fd, select.POLLOUT, seconds)


def _polled(fd: int, events: int, seconds: float | None) -> bool:
    if sys.platform == "win32":
        raise NotImplementedError("not there")
    poll = select.poll()
    poll.register(fd, events)
    return bool(poll.poll(None if seconds is None else 1000 * seconds))
