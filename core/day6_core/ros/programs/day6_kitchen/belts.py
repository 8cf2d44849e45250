"""Who stands at which belt: facts about a graph go in, cooks and belts come out. Pure.

A cook is a node, a belt is a topic, and the shape of the dishes on it is the message type. A cook who waits for another shape, or
on other terms (QoS), stands at the belt and gets nothing: that is a `Refusal`.
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterable, Mapping
from dataclasses import dataclass, field
from functools import cached_property
from heapq import heapify, heappop, heappush

from day6_core.graph.qos import QoS, incompatible_policies

QUIET_TOPICS = ("/rosout", "/parameter_events")
"""Every node stands at these two: they would hide all others."""

TYPED_BY_HAND = "_ros2cli"
"""Nodes of `ros2 topic echo` and `pub`: hidden in ROS's lists, but somebody put them there, and they take and give dishes."""

MOST_COMPARED = 30
"""Of more cooks on one side of a belt it is not looked who gets on with whom."""

DAEMON = "_ros2cli_daemon"


@dataclass(frozen=True)
class End:
    """A publisher (`gives`) or subscription at a topic: the full name of its node, the type's name and the resolved QoS."""

    topic: str
    node: str
    gives: bool
    type: str
    qos: QoS


@dataclass(frozen=True)
class KitchenFacts:
    """A graph: the full names of its nodes, one for each (so that two of one name count), and all ends of its topics."""

    nodes: tuple[str, ...] = ()
    ends: tuple[End, ...] = ()
    commands: Mapping[str, str] = field(default_factory=dict)
    """By the full name of a node of `ros2`: the command that was typed, as far as it is known."""


@dataclass(frozen=True)
class Hand:
    """A cook at a belt, and the shape (message type) that this cook puts on it or waits for."""

    cook: str
    type: str


@dataclass(frozen=True)
class Refusal:
    """Two cooks at one belt who cannot hand each other anything.

    `why` is "type" or "qos"; `detail` is the type that is waited for, or the policies that do not match.
    """

    giver: Hand
    taker: Hand
    why: str
    detail: str


@dataclass(frozen=True)
class Belt:
    """A topic. Of cooks that are not drawn only the number is known here."""

    topic: str
    givers: tuple[Hand, ...]
    takers: tuple[Hand, ...]
    refusals: tuple[Refusal, ...] = ()
    unseen_givers: int = 0
    unseen_takers: int = 0

    @property
    def types(self) -> tuple[str, ...]:
        """The shapes at this belt, those that are put on it first."""
        return tuple(dict.fromkeys(hand.type for hand in (*self.givers, *self.takers)))

    @property
    def wasted(self) -> bool:
        """Whether whatever is put on it stays at its end, because nobody can take it."""
        if not self.givers or self.unseen_takers:
            return False
        return all(self.refusal_of(taker) is not None for taker in self.takers)

    @property
    def lonely(self) -> str:
        """ "unheard" if nobody takes from it, "unfilled" if nobody puts anything on it, else ''."""
        if not self.takers and not self.unseen_takers:
            return "unheard"
        return "" if self.givers or self.unseen_givers else "unfilled"

    def refusal_of(self, taker: Hand) -> Refusal | None:
        """Why this taker gets nothing from anybody who puts dishes on the belt; None if there is somebody it gets them from."""
        return self._starved.get(taker)

    @cached_property
    def _starved(self) -> dict[Hand, Refusal]:
        refused: dict[Hand, dict[Hand, Refusal]] = {}
        for each in self.refusals:
            refused.setdefault(each.taker, {})[each.giver] = each
        return {
            taker: next(iter(by_giver.values()))
            for taker, by_giver in refused.items()
            if not self.unseen_givers and by_giver.keys() >= set(self.givers)
        }


@dataclass(frozen=True)
class Cook:
    """A node, with the belts it puts dishes on and those it takes from; `count` nodes share the name."""

    name: str
    gives: tuple[str, ...] = ()
    takes: tuple[str, ...] = ()
    count: int = 1
    command: str = ""
    """For a node of `ros2`, whose name says nothing: the command."""

    @property
    def title(self) -> str:
        """What a person calls it."""
        return self.command or self.name.removeprefix("/")


@dataclass(frozen=True)
class Content:
    """What is drawn: cooks in the order in which dishes go through their hands, belts in that of their first cooks; `hidden`
    names what is not."""

    cooks: tuple[Cook, ...] = ()
    belts: tuple[Belt, ...] = ()
    hidden: tuple[str, ...] = ()

    def cook(self, name: str) -> Cook | None:
        """The cook of a name."""
        return next((cook for cook in self.cooks if cook.name == name), None)

    def belt(self, topic: str) -> Belt | None:
        """The belt of a topic."""
        return next((belt for belt in self.belts if belt.topic == topic), None)


def is_hidden_topic(topic: str) -> bool:
    """Whether a topic is left out normally."""
    return topic in QUIET_TOPICS or any(part.startswith("_") for part in topic.split("/"))


def is_hidden_node(full_name: str) -> bool:
    """Whether a node is left out normally."""
    name = full_name.rsplit("/", 1)[-1]
    return name.startswith("_") and (not name.startswith(TYPED_BY_HAND) or name.startswith(DAEMON))


def select(facts: KitchenFacts, *, everything: bool = False) -> Content:
    """Return what is drawn: without hidden topics and nodes, unless `everything`."""
    seen_nodes = [name for name in facts.nodes if everything or not is_hidden_node(name)]
    seen = set(seen_nodes)
    by_topic: dict[str, list[End]] = {}
    for end in facts.ends:
        if everything or not is_hidden_topic(end.topic):
            by_topic.setdefault(end.topic, []).append(end)
    belts = []
    for topic, ends in sorted(by_topic.items()):
        if any(end.node in seen for end in ends):
            belts.append(_belt(topic, ends, seen))
    shown = {belt.topic for belt in belts}
    typed_by_hand = {name for name in seen if name.rsplit("/", 1)[-1].startswith(TYPED_BY_HAND)}
    busy = {hand.cook for belt in belts for hand in (*belt.givers, *belt.takers)}
    if not everything:  # `ros2 topic list` is no cook
        seen_nodes = [name for name in seen_nodes if name in busy or name not in typed_by_hand]
    drawn = set(seen_nodes)
    hidden = [name for name in facts.nodes if name not in drawn]
    hidden += [end.topic for end in facts.ends if end.topic not in shown]
    cooks = _cooks(seen_nodes, belts, facts.commands)
    places = {cook.name: place for place, cook in enumerate(cooks)}
    belts.sort(key=lambda belt: (min(places[hand.cook] for hand in belt.givers or belt.takers), belt.topic))
    return Content(cooks, tuple(belts), tuple(dict.fromkeys(hidden)))


def _belt(topic: str, ends: list[End], seen: set[str]) -> Belt:
    refusals = []
    givers = list(dict.fromkeys(end for end in ends if end.gives and end.node in seen))
    takers = list(dict.fromkeys(end for end in ends if not end.gives and end.node in seen))
    for giver in givers[:MOST_COMPARED]:
        for taker in takers[:MOST_COMPARED]:
            why, detail = _refused(giver, taker)
            if why:
                refusals.append(Refusal(Hand(giver.node, giver.type), Hand(taker.node, taker.type), why, detail))
    return Belt(
        topic,
        _hands(end for end in ends if end.gives and end.node in seen),
        _hands(end for end in ends if not end.gives and end.node in seen),
        tuple(dict.fromkeys(refusals)),
        sum(end.gives and end.node not in seen for end in ends),
        sum(not end.gives and end.node not in seen for end in ends),
    )


def _hands(ends: Iterable[End]) -> tuple[Hand, ...]:
    return tuple(dict.fromkeys(Hand(end.node, end.type) for end in ends))


def _refused(giver: End, taker: End) -> tuple[str, str]:
    """Why the one cannot hand the other anything, as in `Refusal`; two empty texts if it can."""
    if giver.type != taker.type:
        return "type", taker.type
    policies = incompatible_policies(giver.qos, taker.qos)
    return ("qos", ", ".join(policy.name.lower() for policy in policies)) if policies else ("", "")


def _command(name: str, known: Mapping[str, str], *, gives: bool) -> str:
    """What was typed to start a node of `ros2`; where nobody knows, what its hands tell: only `pub` gives."""
    if not name.rsplit("/", 1)[-1].startswith(f"{TYPED_BY_HAND}_") or name.rsplit("/", 1)[-1].startswith(DAEMON):
        return ""
    return known.get(name) or ("ros2 topic pub" if gives else "ros2 topic")


def _cooks(names: list[str], belts: list[Belt], commands: Mapping[str, str]) -> tuple[Cook, ...]:
    """Who works together stands together; there, nobody stands before those whose dishes they take, as far as that can be."""
    gives: dict[str, list[str]] = {}
    takes: dict[str, list[str]] = {}
    for belt in belts:
        for table, hands in ((gives, belt.givers), (takes, belt.takers)):
            for name in dict.fromkeys(hand.cook for hand in hands):
                table.setdefault(name, []).append(belt.topic)
    counts = Counter(names)
    return tuple(
        Cook(
            name,
            tuple(gives.get(name, ())),
            tuple(takes.get(name, ())),
            counts[name],
            _command(name, commands, gives=name in gives),
        )
        for name in _in_order(counts, belts, gives)
    )


def _in_order(names: Iterable[str], belts: list[Belt], gives: Mapping[str, list[str]]) -> list[str]:
    """The names in the order in which dishes pass: next comes who waits for the fewest belts that somebody later fills."""
    fillers = {belt.topic: {hand.cook for hand in belt.givers} for belt in belts}
    takers = {belt.topic: {hand.cook for hand in belt.takers} - fillers[belt.topic] for belt in belts}
    waits = Counter(name for belt in belts if belt.givers for name in takers[belt.topic])
    team = _teams(belts)

    def entry(name: str) -> tuple[int, int, int, str]:
        return team.get(name, len(belts)), waits[name], -len(gives.get(name, ())), name

    heap, placed = [entry(name) for name in names], dict[str, None]()
    heapify(heap)
    while heap:
        name = heappop(heap)[-1]
        if name in placed:
            continue
        placed[name] = None
        for topic in gives.get(name, ()):
            fillers[topic].discard(name)
            if not fillers[topic]:
                for taker in takers[topic]:
                    waits[taker] -= 1
                    heappush(heap, entry(taker))
    return list(placed)


def _teams(belts: list[Belt]) -> dict[str, int]:
    """For every cook at a belt the number of the first belt of those that are connected with it by cooks."""
    found: dict[str, int] = {}
    for index, belt in enumerate(belts):
        names = {hand.cook for hand in (*belt.givers, *belt.takers)}
        joined = {found[name] for name in names if name in found}
        first = min({*joined, index})
        found.update({name: first for name, team in found.items() if team in joined})
        found.update(dict.fromkeys(names, first))
    return found
