"""A session of our engine, under the names of Zenoh's. Its tables are touched by its own thread only; see `own` and `others`."""

from __future__ import annotations

from functools import partial
from itertools import count

from day6_core.link.local.connection import Connection
from day6_core.link.local.declared import Announced, Publisher
from day6_core.link.local.frames import LARGEST, LONGEST_KEY, Frame, Kind, Malformed, packed
from day6_core.link.local.liveliness import Liveliness
from day6_core.link.local.loop import Loop, Task
from day6_core.link.local.mesh import Mesh
from day6_core.link.local.others import Others
from day6_core.link.local.own import Own, sample_of
from day6_core.link.local.place import Config
from day6_core.link.local.questions import Asked
from day6_core.link.local.vocabulary import Callback, CancellationToken, CongestionControl, Reply, ZError

_CLOSING_SECONDS = 2.0
_LONGEST_TIMEOUT = 24 * 3600.0
"""Seconds. A question that may take longer is never given up."""


class Session:
    """Any thread may call it, but for `greet`, `take` and `miss`. After `close`, what would have an effect raises ZError."""

    def __init__(self, config: Config) -> None:
        self._zid = config.zid
        self._numbers = count(1)
        self._own = Own()
        self._liveliness = Liveliness(self)
        self._others = Others(self._liveliness.tell)
        self._asked: dict[int, Asked] = {}
        self._closing = False
        self._loop = Loop(self._on_end)
        self._mesh = Mesh(config, self._loop, self)
        self._loop.start()

    def zid(self) -> str:
        """Return the session's id."""
        return self._zid

    def liveliness(self) -> Liveliness:
        """Return what declares and watches tokens."""
        return self._liveliness

    def close(self) -> None:
        """Let the others take what waits for them, for half a second at most, and leave."""
        if not self._closing:
            self._closing = True
            self._loop.do(lambda: self._mesh.finish(self._loop.end))
            self._loop.join(_CLOSING_SECONDS)

    def abandon(self) -> None:
        """In a forked child: drop everything, without telling anybody."""
        self._closing = True
        self._others.clear()
        self._loop.abandon()
        self._mesh.abandon()

    def _on_end(self) -> None:
        self._closing = True
        self._mesh.close()

    def do(self, task: Task) -> None:
        """Have the session's thread do something."""
        self.check()
        self._loop.do(task)

    def do_if_open(self, task: Task) -> None:
        """Have it do something that has no effect after `close`."""
        if not self._closing:
            self._loop.do(task)

    def check(self, key: str = "", payload: bytes = b"") -> None:
        """Raise ZError after `close`, or if something is too long."""
        if self._closing:
            raise ZError("the session is closed")
        if len(payload) > LARGEST or (key and len(key.encode()) > LONGEST_KEY):
            raise ZError(f"{len(payload)} bytes, {len(key)} characters of a key: too long")

    # -- what this process declares ------------------------------------------------------------------------------------

    def declare_subscriber(self, key: str, handler: Callback, *, wants: int = 0, **_: object) -> Announced:
        """Have every message of others called for, and the last `wants` that each publisher has kept."""
        return self.declare(Kind.SUBSCRIBER, key, handler, wants)

    def declare_queryable(self, key: str, handler: Callback, **_: object) -> Announced:
        """Have every question of others called for."""
        return self.declare(Kind.QUERYABLE, key, handler)

    def declare_publisher(self, key: str, *, congestion_control: str, keeps: int = 0, **_: object) -> Publisher:
        """Return a publisher that keeps its last `keeps` messages."""
        self.check(key)
        publisher = Publisher(self, key, congestion_control == CongestionControl.BLOCK, keeps)
        if keeps:
            self._loop.do(partial(self._own.add_keeper, publisher))
        return publisher

    def declare(self, kind: Kind, key: str, handler: Callback | None = None, wants: int = 0) -> Announced:
        """Announce something to the others."""
        self.check(key)
        own = Announced(kind, next(self._numbers), key, wants, handler, self._on_undeclare)
        self._loop.do(partial(self._announce, own))
        return own

    def _announce(self, own: Announced) -> None:
        self._own.add(own)
        self._tell(own.frame)

    def _on_undeclare(self, own: Announced) -> None:
        self.do_if_open(partial(self._withdraw, own))

    def _withdraw(self, own: Announced) -> None:
        self._own.remove(own)
        self._tell(packed(Kind.UNDECLARE, own.number))

    def _tell(self, frame: bytes) -> None:
        for each in self._mesh.connections:
            if each.handshake.done:
                each.send(frame)

    # -- messages and questions ----------------------------------------------------------------------------------------

    def is_heard(self, key: str) -> bool:
        """Whether another process has subscribed."""
        return bool(self._others.to(Kind.SUBSCRIBER, key))

    def publish(self, publisher: Publisher, payload: bytes, attachment: bytes) -> None:
        """Send a message; if the publisher keeps messages, by the session's thread, which also sends what was kept."""
        self.check(payload=payload)
        patiently = publisher.patient and not self._loop.is_current
        listeners = self._others.to(Kind.SUBSCRIBER, publisher.key)
        if publisher.kept is not None:
            for each in listeners if patiently else ():
                each.wait_for_room()
            self._loop.do(partial(self._keep, publisher, payload, attachment))
        elif listeners:
            frame = packed(Kind.MESSAGE, 0, publisher.key_bytes, attachment, payload)
            for each in listeners:
                each.offer(frame, patiently=patiently)

    def _keep(self, publisher: Publisher, payload: bytes, attachment: bytes) -> None:
        assert publisher.kept is not None
        publisher.kept.append((attachment, payload))
        frame = packed(Kind.MESSAGE, 0, publisher.key_bytes, attachment, payload)
        for each in self._others.to(Kind.SUBSCRIBER, publisher.key):
            each.offer(frame)

    def forget(self, publisher: Publisher) -> None:
        """Send nothing any more of what a publisher has kept."""
        if publisher.kept is not None:
            self.do_if_open(partial(self._own.remove_keeper, publisher))

    def get(
        self,
        key: str,
        handler: Callback,
        *,
        payload: bytes = b"",
        attachment: bytes = b"",
        timeout: float,
        cancellation_token: CancellationToken | None = None,
        **_: object,
    ) -> None:
        """Ask everybody who answers for a key."""
        self.check(key, payload)
        those = self._others.to_all(Kind.QUERYABLE, key)
        asked = Asked(handler, set(those), self._on_answered, cancellation_token)
        self._asked[asked.number] = asked
        frame = packed(Kind.QUERY, asked.number, key.encode(), attachment, payload)
        for each in those:
            if not each.send(frame):
                self._loop.do(partial(asked.miss, each))
        if not those:
            asked.end()
        elif timeout < _LONGEST_TIMEOUT:
            self._loop.do(lambda: self._loop.later(timeout, asked.end))

    def _on_answered(self, asked: Asked) -> None:
        if self._asked.pop(asked.number, None) is not None:
            self._loop.do(asked.handler.end)

    # -- what the others send ------------------------------------------------------------------------------------------

    def greet(self, connection: Connection) -> None:
        """Tell a process that has just been connected what there is here."""
        for each in self._own.announced.values():
            connection.send(each.frame)

    def take(self, connection: Connection, frame: Frame) -> None:
        """Take what came. Raises Malformed."""
        if frame.kind == Kind.MESSAGE:
            self._own.take_message(frame)
        elif frame.kind == Kind.QUERY:
            self._own.take_query(connection, frame, self.do_if_open)
        elif frame.kind == Kind.UNDECLARE:
            self._others.unlearn(connection, frame.number)
        elif frame.kind in (Kind.TOKEN, Kind.SUBSCRIBER, Kind.QUERYABLE):
            there = self._others.learn(connection, frame)
            for kept in self._own.kept_for(there):
                connection.send(kept)
        elif frame.kind not in (Kind.REPLY, Kind.LAST_REPLY):
            raise Malformed(f"kind {frame.kind} after it was let in")
        elif (asked := self._asked.get(frame.number)) is not None:
            if frame.kind == Kind.REPLY:
                asked.handler.callback(Reply(sample_of(frame)))
            else:
                asked.miss(connection)

    def miss(self, connection: Connection) -> None:
        """Forget a process whose connection has ended."""
        self._others.miss(connection)
        for asked in list(self._asked.values()):
            asked.miss(connection)

    def tokens(self) -> list[str]:
        """Return the tokens of the others."""
        return self._others.tokens()
