"""Follows publishers that come and go, to tell which said something before anybody who waits for it had found them."""

from __future__ import annotations

import time
from collections import deque
from collections.abc import Mapping
from typing import TYPE_CHECKING, NamedTuple

from day6_core.facts.graph import is_shown
from day6_core.graph.endpoints import EndpointKind, Publisher, Subscription
from day6_core.graph.graph import Change, GraphEvent
from day6_core.graph.qos import Durability
from day6_core.ros.programs.day6_inspector.process_reports import ReportedProcess

if TYPE_CHECKING:
    from day6_core.graph.graph import Graph

SHORT = 1.5
"""Seconds: a publisher that lived longer was heard if anybody listened; and stopping a program takes a person about so long."""

KEPT = 30.0
QUIET = 1.0
"""Seconds without another message after which a program counts as one that published once."""

FEW = 2
MOST_EVENTS = 1000


class _Gone(NamedTuple):
    topic: str
    node: str
    seconds: float
    at: float


class Publications:
    """Listens to the graph until `close`. Events may come on any thread."""

    def __init__(self, graph: Graph) -> None:
        self._graph = graph
        self._events: deque[tuple[float, GraphEvent]] = deque(maxlen=MOST_EVENTS)
        self._began: dict[Publisher, float] = {}
        self._gone: deque[_Gone] = deque(maxlen=50)
        self._since: dict[tuple[str, str], tuple[int, float]] = {}
        """Node and topic -> messages published, and when that number was new."""
        self.close = graph.add_listener(lambda event: self._events.append((time.monotonic(), event)))

    def missed(
        self, received: Mapping[tuple[str, str], int], processes: tuple[ReportedProcess, ...]
    ) -> tuple[tuple[str, str, float], ...]:
        """Return topic, node and life in seconds of publishers that nobody heard although somebody listens.

        `received` is how many messages subscriptions of other processes got, by node and topic.
        """
        now = time.monotonic()
        self._follow(now, received)
        found = {(gone.topic, gone.node): gone.seconds for gone in self._gone if now - gone.at < KEPT}
        for process in processes:
            for inside in process.nodes:
                for topic, count in inside.publishers.items():
                    before, since = self._since.get((inside.node, topic), (-1, now))
                    if before != count:
                        self._since[inside.node, topic] = count, now
                    elif 0 < count <= FEW and now - since > QUIET:
                        found[topic, inside.node] = 0.0
        return tuple((*key, seconds) for key, seconds in found.items() if self._nobody_heard(key[0], received))

    def _follow(self, now: float, received: Mapping[tuple[str, str], int]) -> None:
        while self._events:
            at, (change, subject) = self._events.popleft()
            if not isinstance(subject, Publisher) or subject.origin is None or not is_shown(subject.node.name):
                continue
            said = (subject.node.full_name, subject.topic)
            if change is Change.ENDPOINT_ADDED:
                self._began[subject] = at
                self._since.pop(said, None)
            elif change is Change.ENDPOINT_REMOVED:
                # Never 0.0, which is said of those that live; the clock of Windows has coarse steps.
                lived = max(at - self._began.pop(subject, float("-inf")), 0.001)
                volatile = subject.qos.durability != Durability.TRANSIENT_LOCAL
                own = subject.topic in ("/rosout", "/parameter_events")
                once = self._since.get(said, (0, 0.0))[0] <= FEW
                if lived < SHORT and once and volatile and not own and not subject.delivered:
                    self._gone.append(_Gone(subject.topic, subject.node.full_name, lived, at))

    def _nobody_heard(self, topic: str, received: Mapping[tuple[str, str], int]) -> bool:
        """Whether somebody listens to a topic, and of all who do it is known that nothing came."""
        listeners = [
            each for each in self._graph.endpoints(EndpointKind.SUBSCRIPTION, topic=topic) if is_shown(each.node.name)
        ]
        return bool(listeners) and all(
            isinstance(each, Subscription) and _count(each, received) == 0 for each in listeners
        )


def _count(subscription: Subscription, received: Mapping[tuple[str, str], int]) -> int | None:
    """Return how many messages came to a subscription, None if that is not known."""
    if subscription.origin is None:
        return subscription.received
    return received.get((subscription.node.full_name, subscription.topic))
