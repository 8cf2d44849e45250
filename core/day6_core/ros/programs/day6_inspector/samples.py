"""Samples of what is published: the newest messages of every publisher, without burdening whoever sends them.

A topic that brings much is listened to for one look and then left alone for some; one that brings little is never left. Messages
of other processes stay bytes until one is looked at, and most never are.
"""

from __future__ import annotations

from collections import deque
from collections.abc import Callable, Iterator
from typing import TYPE_CHECKING, Any, NamedTuple

from day6_core.facts.graph import is_shown
from day6_core.graph.endpoints import EndpointKind, Publisher, Subscription
from day6_core.graph.qos import Durability, QoS, Reliability
from day6_core.interfaces import DeserializationError, deserialize
from day6_core.link.classes import message_class

if TYPE_CHECKING:
    from day6_core.graph.node import Node

KEPT = 2
"""Messages of each publisher that are looked at each time; of transforms `MANY`, because one may bring a part of the tree."""

MANY = 60
TRANSFORMS = "tf2_msgs/msg/TFMessage"

MUCH = 12
"""Messages in one look after which a topic is left alone: 25 Hz."""

MUCH_BYTES = 100_000
REST = 5
"""Looks for which it is left alone: 2.5 s, so that a fault is seen within 5."""

LARGEST = 8_000_000
"""Bytes: a larger message is not looked at."""


MOST_TOPICS = 60
"""Topics that are listened to at the same time: a teacher's desktop sees those of a whole class."""


class Sample(NamedTuple):
    """One message that was looked at."""

    publisher: Publisher
    message: Any
    sent_ns: int
    """By the clock of the machine that sent it."""


class _Tap:
    """One topic."""

    def __init__(self, node: Node, first: Publisher) -> None:
        self._node = node
        self._first = first
        self._class = message_class(first.type_name)
        self._most = MANY if first.type_name == TRANSFORMS else KEPT
        self._subscription: Subscription | None = None
        self._resting = 0
        self._kept: dict[Publisher, deque[tuple[Any, int]]] = {}
        self._messages = self._bytes = 0

    @property
    def is_open(self) -> bool:
        return self._subscription is not None

    def close(self) -> None:
        if self._subscription is not None:
            self._subscription.destroy()
            self._subscription = None

    def look(self, offers: list[Publisher]) -> Iterator[Sample]:
        """Return what has come since the last look; open or leave the topic."""
        kept, self._kept = self._kept, {}
        much = self._messages >= MUCH or self._bytes >= MUCH_BYTES
        self._messages = self._bytes = 0
        if self._subscription is not None:
            lasting = self._subscription.qos.durability == Durability.TRANSIENT_LOCAL
            if much:
                self._resting = REST
            if much or (lasting and not all(each.cache is not None for each in offers)):
                self.close()
        elif self._resting:
            self._resting -= 1
        if self._subscription is None and not self._resting:
            self._open()
        for publisher, messages in kept.items():
            for message, sent_ns in messages:
                yield Sample(publisher, self._read(message), sent_ns)

    def _read(self, message: Any) -> Any:
        """Return the message, None if it cannot be read."""
        if not isinstance(message, bytes):
            return message
        try:
            return deserialize(message, self._class) if len(message) <= LARGEST else None
        except DeserializationError:
            return None

    def _open(self) -> None:
        first = self._first
        qos = QoS(self._most, reliability=Reliability.BEST_EFFORT, durability=Durability.BEST_AVAILABLE)
        made = Subscription(self._node, first.topic, first.type_name, first.type_hash, qos, None)
        made.takes_bytes = True
        made.on_ready = self._on_ready
        self._subscription = self._node.graph.add_endpoint(made)

    def _on_ready(self, subscription: Subscription) -> None:
        """Keep what has come. On the thread that brought it: nothing is read here."""
        while (sample := subscription.take()) is not None:
            message, sent_ns, _, publisher, _ = sample
            self._messages += 1
            self._bytes += len(message) if isinstance(message, bytes) else 0
            kept = self._kept.get(publisher)
            if kept is None:
                kept = self._kept[publisher] = deque(maxlen=self._most)
            kept.append((message, sent_ns))


class Samples:
    """Listens to the topics that somebody asks for, through a node that only looks on. On the program's thread."""

    def __init__(self, node: Node, wants: Callable[[str, type], bool]) -> None:
        self._node = node
        self._wants = wants
        """Whether the messages of a topic and class are worth a look."""
        self._taps: dict[tuple[str, str], _Tap | None] = {}
        """Topic and type -> what listens, None where nobody asks for it."""
        self._unread: set[str] = set()
        self.passed_over = 0
        """Topics that are worth a look, and for which there are too many."""
        self.publishers: frozenset[Publisher] = frozenset()
        self.open: frozenset[str] = frozenset()
        """Topics that were listened to since the last look."""

    def look(self) -> list[Sample]:
        """Return what has come since the last look."""
        offers: dict[tuple[str, str], list[Publisher]] = {}
        for each in self._node.graph.endpoints(EndpointKind.PUBLISHER):
            if isinstance(each, Publisher) and is_shown(each.node.name):
                offers.setdefault((each.topic, each.type_name), []).append(each)
        self.publishers = frozenset(each for publishers in offers.values() for each in publishers)
        self.open = frozenset(topic for (topic, _), tap in self._taps.items() if tap is not None and tap.is_open)
        for gone in self._taps.keys() - offers.keys():
            if (tap := self._taps.pop(gone)) is not None:
                tap.close()
        self._unread &= {topic for topic, _ in offers}
        self.passed_over = 0
        return [sample for publishers in offers.values() for sample in self._look_at(publishers)]

    @property
    def unread(self) -> tuple[str, ...]:
        """Topics whose messages cannot be read here, or are too large."""
        return tuple(sorted(self._unread))

    def _look_at(self, publishers: list[Publisher]) -> list[Sample]:
        topic, tap = publishers[0].topic, self._tap(publishers[0])
        came = list(tap.look(publishers)) if tap is not None else []
        read = [each for each in came if each.message is not None]
        if read:
            self._unread.discard(topic)
        elif came:
            self._unread.add(topic)
        return read

    def _tap(self, first: Publisher) -> _Tap | None:
        """Return what listens to a topic and type, made if somebody asks for it; None if nobody does."""
        topic, key = first.topic, (first.topic, first.type_name)
        if key not in self._taps:
            try:
                wanted = self._wants(topic, message_class(first.type_name))
            except (LookupError, ValueError):
                self._unread.add(topic)
                return None
            if wanted and sum(tap is not None for tap in self._taps.values()) >= MOST_TOPICS:
                self.passed_over += 1
                return None
            self._taps[key] = _Tap(self._node, first) if wanted else None
        return self._taps[key]
