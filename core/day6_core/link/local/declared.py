"""What a session declares: announcements that the others are told, and publishers, of which they are told nothing."""

from __future__ import annotations

from collections import deque
from collections.abc import Callable
from typing import TYPE_CHECKING, NamedTuple

from day6_core.link.local.frames import Frame, Kind, Malformed, packed

if TYPE_CHECKING:
    from day6_core.link.local.session import Session
    from day6_core.link.local.vocabulary import Callback

_NUMBER_BYTES = 4


class Announced:
    """A token, subscriber or queryable, of this process (with a handler and `on_undeclare`) or of another one."""

    def __init__(
        self,
        kind: Kind,
        number: int,
        key: str,
        wants: int = 0,
        handler: Callback | None = None,
        on_undeclare: Callable[[Announced], None] | None = None,
    ) -> None:
        self.kind = kind
        self.number = number
        self.key = key
        self.wants = wants
        """How many kept messages of each publisher."""
        self.handler = handler
        self._on_undeclare = on_undeclare

    def undeclare(self) -> None:
        """Take it back; a second call does nothing."""
        self.handler = None
        on_undeclare, self._on_undeclare = self._on_undeclare, None
        if on_undeclare is not None:
            on_undeclare(self)

    def call(self, argument: object) -> None:
        """Call the handler, if it has not been taken back."""
        handler = self.handler
        if handler is not None:
            handler.callback(argument)

    @property
    def frame(self) -> bytes:
        """What the others are told."""
        return packed(self.kind, self.number, self.key.encode(), payload=self.wants.to_bytes(_NUMBER_BYTES, "little"))


def announced_in(frame: Frame) -> Announced:
    """Return what a frame tells of another process. Raises Malformed."""
    if len(frame.payload) != _NUMBER_BYTES or not frame.number:
        raise Malformed(f"{len(frame.payload)} bytes, number {frame.number}")
    return Announced(Kind(frame.kind), frame.number, frame.key, int.from_bytes(frame.payload, "little"))


class MatchingStatus(NamedTuple):
    """Whether anybody listens."""

    matching: bool


class Publisher:
    """Made by `Session.declare_publisher`."""

    def __init__(self, session: Session, key: str, patient: bool, keeps: int) -> None:
        self._session = session
        self.key = key
        self.key_bytes = key.encode()
        self.patient = patient
        """Whether it waits for those who are slow."""
        self.kept: deque[tuple[bytes, bytes]] | None = deque(maxlen=keeps) if keeps else None
        """Attachments and payloads. Only the session's thread reads and changes it."""

    @property
    def matching_status(self) -> MatchingStatus:
        """Whether anybody listens."""
        return MatchingStatus(self._session.is_heard(self.key))

    def put(self, payload: bytes, *, attachment: bytes) -> None:
        """Send a message to everybody who listens; any thread may. Raises ZError."""
        self._session.publish(self, payload, attachment)

    def undeclare(self) -> None:
        """Keep nothing any more."""
        self._session.forget(self)
