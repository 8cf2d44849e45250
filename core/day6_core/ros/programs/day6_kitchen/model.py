"""What the kitchen's window shows of the live graph: cooks and belts, measured rates, dishes on their way.

It only looks. It subscribes to nothing: what passes on a topic is read from the counters of the publishers, which know what went
through this process; and what other processes of this machine hand to each other the link can hear. Of everything else the rate
is not known: never 0.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable
from typing import TYPE_CHECKING

from day6_core.graph import EndpointKind, Graph, GraphEvent, Publisher
from day6_core.graph.endpoints import Endpoint
from day6_core.graph.qos import QoS, incompatible_policies
from day6_core.ros.programs.day6_kitchen.belts import Content, End, KitchenFacts, select
from day6_core.ros.programs.day6_kitchen.dishes import Conveyor, Dishes, Lane
from day6_core.ros.programs.day6_kitchen.rates import Rate

if TYPE_CHECKING:
    from day6_core.link.passing import Passing

LOOK_SECONDS = 0.09
"""Between two looks at the counters, at least."""

GRAPH_SECONDS = 0.2
"""Between two looks at a graph that changes."""


class Kitchen:
    """The model of one kitchen window. Only the window calls `look` and `show_everything`, before it draws.

    `content` is replaced as a whole and `version` raised when the graph changed; `rates` has messages per second by topic, None
    for a topic of which nothing passes through this process.
    """

    def __init__(self, graph: Graph, own_name: str, listen_in: Callable[[], Passing | None] = lambda: None) -> None:
        self._graph = graph
        self._own_name = own_name
        self._listen_in = listen_in
        self._passing: Passing | None = None
        self._stale = True
        self._looked = self._read = -1e9
        self._counts: dict[tuple[int, bool], int] = {}
        """What was counted at the last look, by publisher and by whether it was heard or passed through here."""
        self._measured: dict[str, Rate] = {}
        self._sent_elsewhere: set[int] = set()
        self._topics: set[str] = set()
        """The topics that are shown."""
        self.everything = False
        """Whether hidden nodes and topics are shown."""
        self.content = Content()
        self.version = 0
        self.rates: dict[str, float | None] = {}
        self.dishes = Dishes()
        self.conveyor = Conveyor()

    def on_change(self, event: GraphEvent) -> None:
        """The graph has changed (any thread)."""
        self._stale = True

    def close(self) -> None:
        """Hear nothing any more (once, at the end)."""
        if self._passing is not None:
            self._passing.close()

    def show_everything(self, everything: bool) -> None:
        """Show hidden nodes and topics, or not."""
        self.everything = everything
        self._stale, self._read = True, -1e9

    def look(self, now: float) -> None:
        """Read what is due at the monotonic time `now` (s): the graph, if it has changed, and the counters."""
        if self._stale and now - self._read >= GRAPH_SECONDS:
            self._stale, self._read = False, now
            endpoints = self._graph.endpoints(EndpointKind.PUBLISHER, EndpointKind.SUBSCRIPTION)
            publishers = [each for each in endpoints if isinstance(each, Publisher)]
            self._sent_elsewhere = _sent_elsewhere(
                publishers, (each for each in endpoints if each.kind == EndpointKind.SUBSCRIPTION)
            )
            self._show(select(self._facts(endpoints), everything=self.everything))
        if now - self._looked >= LOOK_SECONDS:
            self._looked = now
            self._count(now)
        self.conveyor.advance(now)

    def _show(self, content: Content) -> None:
        if content == self.content and self.version:
            return
        for type_name in sorted({kind for belt in content.belts for kind in belt.types}):
            self.dishes.of(type_name)
        self.content = content
        self._topics = {belt.topic for belt in content.belts}
        self.version += 1

    def _facts(self, endpoints: Iterable[Endpoint]) -> KitchenFacts:
        """Everything but this program's own node."""
        ends = [
            End(
                endpoint.topic,
                endpoint.node.full_name,
                endpoint.kind == EndpointKind.PUBLISHER,
                endpoint.type_name,
                endpoint.qos,
            )
            for endpoint in endpoints
            if endpoint.node.name != self._own_name
        ]
        return KitchenFacts(
            tuple(node.full_name for node in self._graph.nodes if node.name != self._own_name), tuple(ends)
        )

    def _count(self, now: float) -> None:
        counts: dict[tuple[int, bool], int] = {}
        fresh: dict[str, int | None] = {}
        elsewhere: list[Publisher] = []
        for publisher in self._graph.endpoints(EndpointKind.PUBLISHER):
            if not isinstance(publisher, Publisher):
                continue
            topic, copies = publisher.topic, _copies(publisher)
            passed: int | None = publisher.delivered
            if not copies:
                passed = None
                if publisher.entity_id in self._sent_elsewhere and topic in self._topics:
                    elsewhere.append(publisher)
                    passed = self._passing.count(publisher) if self._passing is not None else None
            if passed is None:
                fresh.setdefault(topic, None)
                continue
            key = (publisher.entity_id, copies == 0)
            before = self._counts.get(key, passed)
            more = max(0, passed - before) // (copies or 1)
            counts[key] = before + more * (copies or 1)
            fresh[topic] = (fresh.get(topic) or 0) + more
            lane: Lane = (topic, publisher.node.full_name)
            self.conveyor.put(lane, more)
        self._counts = counts
        if elsewhere and self._passing is None:
            self._passing = self._listen_in()
        if self._passing is not None:
            self._passing.follow(elsewhere)
        rates: dict[str, float | None] = {}
        measured: dict[str, Rate] = {}
        for topic, more_or_none in fresh.items():
            if more_or_none is None:
                rates[topic] = None
                continue
            rate = measured[topic] = self._measured.get(topic) or Rate()
            rate.see(now, more_or_none)
            rates[topic] = rate.hertz(now)
        self._measured, self.rates = measured, rates


def _copies(publisher: Publisher) -> int:
    """How often one of its messages is counted here; 0 where none of them passes through this process.

    The link counts a message of another process once for each subscription here.
    """
    return 1 if publisher.origin is None else len(publisher.matched)


def _sent_elsewhere(publishers: Iterable[Publisher], subscriptions: Iterable[Endpoint]) -> set[int]:
    """The entity ids of those publishers of other processes whose messages go to a third one.

    What only its own process takes, or nobody, is not sent, and nobody can hear it.
    """
    takers: dict[str, dict[tuple[str, QoS, object], None]] = {}
    for each in subscriptions:
        if each.origin is not None:
            takers.setdefault(each.topic, {})[each.type_name, each.qos, each.origin] = None
    return {
        publisher.entity_id
        for publisher in publishers
        if publisher.origin is not None
        and any(
            type_name == publisher.type_name
            and origin != publisher.origin
            and not incompatible_policies(publisher.qos, qos)
            for type_name, qos, origin in takers.get(publisher.topic, ())
        )
    }
