"""The meeting point: a router session, run by whichever process holds a lock, through which all others find each other.

When the holder dies, the messages among the others continue, and one of them becomes the next holder.
"""

from __future__ import annotations

from contextlib import suppress
from pathlib import Path
from typing import TYPE_CHECKING

from day6_core.link.config import meeting_config
from day6_core.link.engine_thread import open_session
from day6_core.link.file_lock import FileLock
from day6_core.link.kept_files import identity, spared
from day6_core.link.keys import presence_token
from day6_core.link.paths import MeetingPlace, remove_socket

if TYPE_CHECKING:
    import zenoh

_kept: list[MeetingPoint] = []
"""Those this process runs until it ends."""


class MeetingPoint:
    """The meeting point of a domain, as far as this process holds it or may come to."""

    def __init__(self, place: MeetingPlace, domain_id: int) -> None:
        self._place = place
        self._domain_id = domain_id
        self._lock = FileLock(place.meeting_lock)
        self._session: zenoh.Session | None = None
        self._socket: tuple[int, int] | None = None
        """The identity of its file."""
        self._token: zenoh.LivelinessToken | None = None

    @property
    def held_here(self) -> bool:
        """Whether this process runs it."""
        return self._session is not None

    @property
    def files(self) -> tuple[Path, ...]:
        """What its holder has to have."""
        return self._place.meeting_lock, *(() if self._place.tcp else (self._place.meeting_socket,))

    def try_to_hold(self) -> bool:
        """Become the holder if there is none; return whether this process is the holder.

        Raises:
            zenoh.ZError, OSError: the session or the lock file could not be opened.
        """
        if self._session is not None:
            return True
        if not self._lock.try_acquire():
            return False
        import zenoh

        try:
            session = self._open()
        except (zenoh.ZError, OSError):
            self._lock.release()
            raise
        self._token = session.liveliness().declare_token(presence_token(self._domain_id, "meeting", str(session.zid())))
        self._session, self._socket = session, identity(self._place.meeting_socket)
        return True

    def _open(self) -> zenoh.Session:
        import zenoh

        try:
            return open_session(meeting_config(self._place))
        except zenoh.ZError:
            if not self._place.tcp:
                raise
        # No process holds the meeting point, so its port is used by an unrelated program.
        self._place.choose_another_port()
        return open_session(meeting_config(self._place))

    def keep(self) -> None:
        """Run it until this process ends, then leave its end to the system; does nothing if another process holds it.

        A router that is closed while a process connects writes `thread 'rx-0' panicked` to the terminal: Zenoh 1.10 clears its
        tables before the last connection is gone (zenoh/src/net/runtime/mod.rs, `close_inner`). So it is never closed, and
        its session never freed, which would close it.
        """
        if self._session is None:
            return
        from _ctypes import Py_INCREF  # not ctypes, as which a student's file may be called

        Py_INCREF(self._session)
        _kept.append(self)

    def close(self) -> None:
        """Stop running it; another process takes over, or has done so: Zenoh removes whatever has its socket's name."""
        session, self._session = self._session, None
        if session is not None:
            path = self._place.meeting_socket
            others = identity(path) not in (None, self._socket)
            with spared((path, path.with_name(f"{path.name}.lock")) if others else ()):
                session.close()
        self._lock.release()

    def remove_socket(self) -> None:
        """Remove the socket, so that nobody finds it any more."""
        if not self._place.tcp:
            with suppress(OSError):  # the folder may be gone
                remove_socket(self._place.meeting_socket)

    def release_copy(self) -> None:
        """In a forked child: close the child's copy of the lock; the parent still holds it."""
        self._lock.release()


def remove_kept_sockets() -> None:
    """At the end of this process: let nobody look for a meeting point that is about to go."""
    for each in _kept:
        each.remove_socket()


def release_copies() -> None:
    """In a forked child: close the copies of the locks of kept meeting points."""
    for each in _kept:
        each.release_copy()
