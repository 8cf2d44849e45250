"""What the kitchen's window shows of the live graph: cooks and belts, measured rates, dishes on their way and left over.

It only looks. It subscribes to nothing: what passes on a topic is read from the counters of the publishers, which know what went
through this process; what other processes of this machine hand to each other the link can hear; and what one of them publishes
to nobody it tells when it is asked. Of everything else the rate is not known: never 0.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping, Sequence
from typing import TYPE_CHECKING

from day6_core.graph import EndpointKind, Graph, GraphEvent, Publisher
from day6_core.graph.endpoints import Endpoint
from day6_core.graph.qos import QoS, incompatible_policies
from day6_core.ros.programs.day6_kitchen.belts import TYPED_BY_HAND, Content, End, KitchenFacts, select
from day6_core.ros.programs.day6_kitchen.dishes import Conveyor, Dishes, Lane
from day6_core.ros.programs.day6_kitchen.rates import Rate

if TYPE_CHECKING:
    from day6_core.link.passing import Passing

LOOK_SECONDS = 0.09
"""Between two looks at the counters, at least."""

GRAPH_SECONDS = 0.2
"""Between two looks at a graph that changes."""

Told = tuple[str, str]
"""The full name of a node and a topic that it publishes."""


class Kitchen:
    """The model of one kitchen window. Only the window calls `look` and `show_everything`, before it draws.

    `content` is replaced as a whole and `version` raised when the graph changed; `rates` has messages per second by topic, None
    for a topic of which nothing passes through this process. `command_of` knows what was typed to start a program here.
    """

    def __init__(
        self,
        graph: Graph,
        own_name: str,
        listen_in: Callable[[], Passing | None] = lambda: None,
        command_of: Callable[[int], Sequence[str]] = lambda pid: (),
    ) -> None:
        self._graph = graph
        self._own_name = own_name
        self._listen_in = listen_in
        self._command_of = command_of
        self._passing: Passing | None = None
        self._stale = True
        self._looked = self._read = -1e9
        self._counts: dict[tuple[int, str], int] = {}
        """What was counted at the last look, by publisher and by who counted."""
        self._measured: dict[str, Rate] = {}
        self._sent_elsewhere: set[int] = set()
        self._topics: set[str] = set()
        """The topics that are shown."""
        self._wasted: set[str] = set()
        """Those of them whose messages nobody takes."""
        self.unheard = False
        """Whether another process publishes something to nobody, so that only it can tell how much."""
        self.told: Mapping[Told, int] = {}
        """What other processes have told: how many messages they published. Replaced as a whole."""
        self.everything = False
        """Whether hidden nodes and topics are shown."""
        self.content = Content()
        self.version = 0
        self.rates: dict[str, float | None] = {}
        self.left: dict[str, int] = {}
        """By topic whose messages nobody takes: how many were counted since."""
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
        self._wasted = {belt.topic for belt in content.belts if belt.wasted}
        self.left = {topic: count for topic, count in self.left.items() if topic in self._wasted}
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
        nodes = [node for node in self._graph.nodes if node.name != self._own_name]
        commands = {}
        for node in nodes:
            number = node.name.removeprefix(f"{TYPED_BY_HAND}_")
            if node.origin is None and number.isdecimal() and (words := self._command_of(int(number))):
                commands[node.full_name] = " ".join(words[:3])
        return KitchenFacts(tuple(node.full_name for node in nodes), tuple(ends), commands)

    def _count(self, now: float) -> None:
        counts: dict[tuple[int, str], int] = {}
        fresh: dict[str, int | None] = {}
        elsewhere: list[Publisher] = []
        self.unheard = False
        for publisher in self._graph.endpoints(EndpointKind.PUBLISHER):
            if not isinstance(publisher, Publisher):
                continue
            topic, copies = publisher.topic, _copies(publisher)
            passed, who = self._passed(publisher, copies, elsewhere)
            if passed is None:
                fresh.setdefault(topic, None)
                continue
            key = (publisher.entity_id, who)
            before = self._counts.get(key, passed)
            more = max(0, passed - before) // (copies or 1)
            counts[key] = before + more * (copies or 1)
            fresh[topic] = (fresh.get(topic) or 0) + more
            if more and topic in self._wasted:
                self.left[topic] = self.left.get(topic, 0) + more
            lane: Lane = (topic, publisher.node.full_name)
            self.conveyor.put(lane, more)
        self._counts = counts
        if elsewhere and self._passing is None:
            self._passing = self._listen_in()
        if self._passing is not None:
            self._passing.follow(elsewhere)
        self._measure(now, fresh)

    def _passed(self, publisher: Publisher, copies: int, elsewhere: list[Publisher]) -> tuple[int | None, str]:
        """How many messages of a publisher were counted, None where nobody can, and who counted.

        One whose messages go from one other process to another is put into `elsewhere`.
        """
        if copies:
            return publisher.delivered, "here"
        if publisher.topic not in self._topics:
            return None, ""
        if publisher.entity_id in self._sent_elsewhere:
            elsewhere.append(publisher)
            return (self._passing.count(publisher) if self._passing is not None else None), "heard"
        self.unheard = True
        return self.told.get((publisher.node.full_name, publisher.topic)), "told"

    def _measure(self, now: float, fresh: Mapping[str, int | None]) -> None:
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
