"""What the other processes have declared, by their connections. Changed by the session's thread only; any thread may read.

The tuples are replaced and never changed, so that nobody needs a lock, in which a garbage collection might destroy a node.
"""

from __future__ import annotations

from collections.abc import Callable

from day6_core.link.local.connection import Connection
from day6_core.link.local.declared import Announced, announced_in
from day6_core.link.local.frames import Frame, Kind, Malformed
from day6_core.link.local.vocabulary import SampleKind, matches

MOST_ANNOUNCED = 50_000
"""Of one process: far more than the nodes and endpoints that the graph admits."""


class Others:
    """`on_token(key, kind)` is called when a token comes or goes."""

    def __init__(self, on_token: Callable[[str, SampleKind], None]) -> None:
        self._on_token = on_token
        self._ways: dict[Kind, dict[str, tuple[Connection, ...]]] = {Kind.SUBSCRIBER: {}, Kind.QUERYABLE: {}}
        self._of: dict[Connection, dict[int, Announced]] = {}

    def to(self, kind: Kind, key: str) -> tuple[Connection, ...]:
        """Return the connections to those who have subscribed to a key, or answer for it."""
        return self._ways[kind].get(key, ())

    def to_all(self, kind: Kind, pattern: str) -> dict[Connection, None]:
        """Return the connections to those who have declared a key that matches, in the order of their declarations."""
        ways = [way for key, way in list(self._ways[kind].items()) if matches(pattern, key)]
        return dict.fromkeys(each for way in ways for each in way)

    def tokens(self) -> list[str]:
        """Return all tokens; any thread may, of what changes meanwhile it gets the old or the new."""
        announced = (each for those in list(self._of.values()) for each in list(those.values()))
        return [each.key for each in announced if each.kind == Kind.TOKEN]

    def learn(self, connection: Connection, frame: Frame) -> Announced:
        """Take what a process has declared. Raises Malformed."""
        there = announced_in(frame)
        those = self._of.setdefault(connection, {})
        if there.number in those or len(those) >= MOST_ANNOUNCED:
            raise Malformed("declared twice, or too much")
        those[there.number] = there
        if there.kind == Kind.TOKEN:
            self._on_token(there.key, SampleKind.PUT)
        elif connection not in self.to(there.kind, there.key):
            self._ways[there.kind][there.key] = (*self.to(there.kind, there.key), connection)
        return there

    def unlearn(self, connection: Connection, number: int) -> None:
        """Take that a process has taken something back. Raises Malformed."""
        there = self._of.get(connection, {}).pop(number, None)
        if there is None:
            raise Malformed("what it takes back was never declared")
        if there.kind == Kind.TOKEN:
            self._on_token(there.key, SampleKind.DELETE)
        elif not any(each.kind == there.kind and each.key == there.key for each in self._of[connection].values()):
            left = tuple(each for each in self.to(there.kind, there.key) if each is not connection)
            self._ways[there.kind][there.key] = left
            if not left:
                del self._ways[there.kind][there.key]

    def miss(self, connection: Connection) -> None:
        """Forget a process."""
        for number in list(self._of.get(connection, ())):
            self.unlearn(connection, number)
        self._of.pop(connection, None)

    def clear(self) -> None:
        """In a forked child: nothing is sent any more."""
        self._ways = {Kind.SUBSCRIBER: {}, Kind.QUERYABLE: {}}
