"""Questions (Zenoh's queries): what one process asks, and what the processes that can answer make of it.

The one who asks counts who has not said yet that no answer will follow. A process says so once all its queryables that were asked
have dropped the question.
"""

from __future__ import annotations

from collections.abc import Callable
from itertools import count
from typing import TYPE_CHECKING

from day6_core.link.local.frames import Frame, Kind, packed
from day6_core.link.local.vocabulary import Payload

if TYPE_CHECKING:
    from day6_core.link.local.connection import Connection
    from day6_core.link.local.vocabulary import Callback, CancellationToken

_numbers = count(1)


class Asked:
    """A question of this process. Only the session's thread calls `miss`; `end` may be called by any."""

    def __init__(
        self,
        handler: Callback,
        those: set[Connection],
        on_end: Callable[[Asked], None],
        token: CancellationToken | None,
    ) -> None:
        self.number = next(_numbers)
        self.handler = handler
        self._missing = those
        self._on_end = on_end
        self._token = token
        if token is not None:
            token.open.add(self)

    def miss(self, connection: Connection) -> None:
        """Expect nothing more over a connection."""
        self._missing.discard(connection)
        if not self._missing:
            self.end()

    def end(self) -> None:
        """Expect nothing more at all."""
        if self._token is not None:
            self._token.open.discard(self)
        self._on_end(self)


class Query:
    """A question to one queryable of this process."""

    def __init__(self, frame: Frame, connection: Connection, on_drop: Callable[[], None]) -> None:
        self.key_expr = frame.key
        self.payload = Payload(frame.payload) if frame.payload else None
        self.attachment = Payload(frame.attachment) if frame.attachment else None
        self._number = frame.number
        self._connection = connection
        self._on_drop: Callable[[], None] | None = on_drop

    def reply(self, key: str, payload: bytes, *, attachment: bytes = b"") -> None:
        """Answer; any thread may."""
        self._connection.send(packed(Kind.REPLY, self._number, key.encode(), attachment, payload))

    def drop(self) -> None:
        """No answer follows; a second call does nothing."""
        on_drop, self._on_drop = self._on_drop, None
        if on_drop is not None:
            on_drop()

    def __enter__(self) -> Query:
        return self

    def __exit__(self, *_: object) -> None:
        self.drop()
