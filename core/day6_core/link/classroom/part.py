"""The part a machine has in a class: the teacher's or a pupil's. The gateway asks it how to open, and what to join."""

from __future__ import annotations

import threading
from collections.abc import Callable
from queue import SimpleQueue
from typing import TYPE_CHECKING, Protocol

from day6_core.link.naming import Naming
from day6_core.link.state import DoorState

if TYPE_CHECKING:
    import zenoh

MOST_WAITING = 500
"""Notes and orders in the queue; more are dropped, as on a slow network."""


class ClassPart(Protocol):
    """Everything is called on the gateway's thread."""

    @property
    def naming(self) -> Naming | None:
        """How keys are written outside; None as long as this machine does not belong to the class."""

    @property
    def problem(self) -> DoorState | None:
        """Why it does not, if the other machine is connected."""

    @property
    def joined(self) -> int | None:
        """How many belong to the class now; None where that is not known here."""

    is_closed: bool
    """Whether others reach only this machine by it, and only as pupils."""

    def configure(self, config: zenoh.Config) -> None:
        """Change the settings of the outer session before it is opened."""

    def begin(self, session: zenoh.Session, domain_id: int) -> None:
        """The outer session was opened. May raise ZError."""

    def poll(self) -> None:
        """Called again and again while the session is open; it must not block."""

    def end(self) -> None:
        """The session is being closed. Also called where it was never opened."""


class Outbox:
    """Sends on a thread of its own, as a full queue makes Zenoh wait."""

    def __init__(self, session: zenoh.Session, report: Callable[[str, Exception], None]) -> None:
        self._session = session
        self._report = report
        self._queue: SimpleQueue[tuple[str, bytes] | None] = SimpleQueue()
        threading.Thread(target=self._run, name="day6-class", daemon=True).start()

    def put(self, key: str, data: bytes) -> bool:
        """Send this soon; False if too much is waiting. Any thread."""
        if self._queue.qsize() >= MOST_WAITING:
            return False
        self._queue.put((key, data))
        return True

    def close(self) -> None:
        """What has not been sent is not sent."""
        while not self._queue.empty():
            self._queue.get()
        self._queue.put(None)

    def _run(self) -> None:
        import zenoh

        while (entry := self._queue.get()) is not None:
            try:
                self._session.put(*entry, congestion_control=zenoh.CongestionControl.DROP)
            except zenoh.ZError as error:
                self._report("not sent to the class", error)
