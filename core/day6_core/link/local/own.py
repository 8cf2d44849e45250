"""What this process has declared, and how what others send gets there. Only the session's thread uses it."""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Callable, Iterator

from day6_core.link.local.connection import Connection
from day6_core.link.local.declared import Announced, Publisher
from day6_core.link.local.frames import Frame, Kind, packed
from day6_core.link.local.questions import Query
from day6_core.link.local.vocabulary import Payload, Sample, matches


class Own:
    """Tokens, subscribers, queryables, and the publishers that keep messages."""

    def __init__(self) -> None:
        self.announced: dict[int, Announced] = {}
        """What the others are told, by number."""
        self._receivers: defaultdict[str, list[Announced]] = defaultdict(list)
        """The subscribers by key."""
        self._keepers: defaultdict[str, list[Publisher]] = defaultdict(list)

    def add(self, own: Announced) -> None:
        """Add a token, subscriber or queryable."""
        self.announced[own.number] = own
        if own.kind == Kind.SUBSCRIBER:
            self._receivers[own.key].append(own)

    def remove(self, own: Announced) -> None:
        """Remove it."""
        del self.announced[own.number]
        if own.kind == Kind.SUBSCRIBER:
            self._receivers[own.key].remove(own)
            if not self._receivers[own.key]:
                del self._receivers[own.key]

    def add_keeper(self, publisher: Publisher) -> None:
        """Add a publisher that keeps messages."""
        self._keepers[publisher.key].append(publisher)

    def remove_keeper(self, publisher: Publisher) -> None:
        """Remove it."""
        self._keepers[publisher.key].remove(publisher)
        if not self._keepers[publisher.key]:
            del self._keepers[publisher.key]

    def kept_for(self, subscriber: Announced) -> Iterator[bytes]:
        """Yield the messages that a new subscriber of another process is to get."""
        for publisher in self._keepers.get(subscriber.key, ()) if subscriber.wants else ():
            for attachment, payload in list(publisher.kept or ())[-subscriber.wants :]:
                yield packed(Kind.MESSAGE, subscriber.number, subscriber.key.encode(), attachment, payload)

    def take_message(self, frame: Frame) -> None:
        """Give a message to the subscriber, or all of them, that it is for."""
        sample = sample_of(frame)
        if frame.number:
            one = self.announced.get(frame.number)
            those = [one] if one is not None and one.key == frame.key else []
        else:
            those = list(self._receivers.get(frame.key, ()))
        for each in those:
            each.call(sample)

    def take_query(self, connection: Connection, frame: Frame, do: Callable[[Callable[[], None]], None]) -> None:
        """Give a question to all that can answer; once they have dropped it, by `do`, say so to the one who asks."""
        those = [
            each for each in self.announced.values() if each.kind == Kind.QUERYABLE and matches(frame.key, each.key)
        ]
        left = len(those)

        def drop_one() -> None:
            nonlocal left
            left -= 1
            if left <= 0:
                connection.send(packed(Kind.LAST_REPLY, frame.number))

        if not those:
            drop_one()
        for each in those:
            query = Query(frame, connection, lambda: do(drop_one))
            if each.handler is None:
                query.drop()
            else:
                each.call(query)


def sample_of(frame: Frame) -> Sample:
    """Return what a handler gets."""
    return Sample(frame.key, Payload(frame.payload), Payload(frame.attachment) if frame.attachment else None)
