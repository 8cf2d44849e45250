"""Counts the messages that other processes of this machine send each other, for a window that shows what passes.

It is no subscription: no token announces it, so no graph shows it and nobody publishes because of it. It hears what goes over
Zenoh anyway, and reads of a message only who sent it. Processes of other machines are left alone: their messages would have to be
carried here for nothing else.
"""

from __future__ import annotations

import threading
from collections.abc import Callable, Iterable
from queue import SimpleQueue
from typing import TYPE_CHECKING, Any

from day6_core.graph.endpoints import Publisher
from day6_core.interrupts import unsignalled
from day6_core.link.attachment import unpack
from day6_core.link.engine import engine_of
from day6_core.link.engine_thread import callback
from day6_core.link.keys import data_key
from day6_core.link.remote import Origin

if TYPE_CHECKING:
    import zenoh

MOST_TOPICS = 200
"""More at a time are not counted."""


class Passing:
    """Counters by publisher. Made by `day6_core.link.listen_in`; any thread may call anything but `close`, which waits."""

    def __init__(self, session: Callable[[], zenoh.Session | None], is_neighbour: Callable[[str], bool]) -> None:
        self._session = session
        self._is_neighbour = is_neighbour
        self._keys: frozenset[str] = frozenset()
        self._open: frozenset[str] = frozenset()
        """The keys that are heard."""
        self._counts: dict[bytes, int] = {}
        self._wanted: SimpleQueue[frozenset[str] | None] = SimpleQueue()
        self._thread: threading.Thread | None = None
        self._closed = False

    @property
    def closed(self) -> bool:
        """Whether it has been closed."""
        return self._closed

    def follow(self, publishers: Iterable[Publisher]) -> None:
        """Count what these send from now on, and nothing else; returns at once."""
        chosen = [
            each for each in publishers if isinstance(each.origin, Origin) and self._is_neighbour(each.origin.zid)
        ]
        keys = frozenset(list(dict.fromkeys(data_key(each) for each in chosen))[:MOST_TOPICS])
        counts = {each.gid: self._counts.get(each.gid, 0) for each in chosen}
        if counts.keys() != self._counts.keys():
            self._counts = counts
        if keys == self._keys or self._closed:
            return
        self._keys = keys
        if self._thread is None:
            self._thread = threading.Thread(target=self._work, name="day6-passing", daemon=True)
            with unsignalled():
                self._thread.start()
        self._wanted.put(keys)

    def count(self, publisher: Publisher) -> int | None:
        """How many messages of a publisher were heard since it is followed; None if it is not."""
        return self._counts.get(publisher.gid) if data_key(publisher) in self._open else None

    def close(self) -> None:
        """Hear nothing any more; a second call does nothing."""
        self._closed = True
        thread, self._thread = self._thread, None
        if thread is not None:
            self._wanted.put(None)
            thread.join(timeout=2.0)

    def _work(self) -> None:
        """On a thread of its own, because declaring may wait for Zenoh's."""
        engine = engine_of(self._session())
        subscribers: dict[str, Any] = {}
        while (keys := self._wanted.get()) is not None:
            try:
                for key in subscribers.keys() - keys:
                    subscribers.pop(key).undeclare()
                for key in keys - subscribers.keys():
                    if (session := self._session()) is not None:
                        handler = engine.handlers.Callback(callback(self._heard), indirect=False)
                        remote = engine.Locality.REMOTE
                        subscribers[key] = session.declare_subscriber(key, handler, allowed_origin=remote)
            except engine.ZError:  # the link is being closed; what is not heard is not counted as 0
                self._open = frozenset()
                continue
            self._open = frozenset(subscribers)
        self._open = frozenset()
        for subscriber in subscribers.values():
            try:
                subscriber.undeclare()
            except engine.ZError:
                continue

    def _heard(self, sample: zenoh.Sample) -> None:
        # On Zenoh's thread: nothing here may block, and no exception may escape.
        if sample.attachment is None:
            return
        try:
            gid = unpack(sample.attachment.to_bytes()).gid
        except ValueError:
            return
        counts = self._counts
        if gid in counts:
            counts[gid] += 1
