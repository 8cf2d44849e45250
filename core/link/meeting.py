"""The meeting point: a router session kept by whichever process gets the lock, through which all others get to know
one another. When its keeper dies, the messages of the others go on, and one of them keeps the next.
"""

from __future__ import annotations

from typing import TYPE_CHECKING

from day6_tui.core.link.config import meeting_config
from day6_tui.core.link.file_lock import FileLock
from day6_tui.core.link.keys import sign
from day6_tui.core.link.paths import Place

if TYPE_CHECKING:
    import zenoh


class MeetingPoint:
    """This process's chance to keep the meeting point of a domain."""

    def __init__(self, place: Place, domain_id: int) -> None:
        self._place = place
        self._domain_id = domain_id
        self._lock = FileLock(place.meeting_lock)
        self._session: zenoh.Session | None = None
        self._token: zenoh.LivelinessToken | None = None

    @property
    def kept_here(self) -> bool:
        """Say whether this process keeps it."""
        return self._session is not None

    def try_to_keep(self) -> bool:
        """Become the keeper if there is none; say whether this process is it. Raises zenoh.ZError, OSError."""
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
        self._token = session.liveliness().declare_token(sign(self._domain_id, "meeting", str(session.zid())))
        self._session = session
        return True

    def _open(self) -> zenoh.Session:
        import zenoh

        try:
            return zenoh.open(meeting_config(self._place))
        except zenoh.ZError:
            if not self._place.tcp:
                raise
        # Nobody keeps the meeting point, but somebody has its port: a program of anybody's.
        self._place.choose_another_port()
        return zenoh.open(meeting_config(self._place))

    def close(self) -> None:
        """Stop keeping it; another process takes over."""
        session, self._session = self._session, None
        if session is not None:
            session.close()
        self._lock.release()

    def release_copy(self) -> None:
        """In a forked child: close the child's copy of the lock; the parent keeps it."""
        self._lock.release()
