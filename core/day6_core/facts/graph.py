"""What a graph holds: who publishes, subscribes, offers and uses what, and who cannot hear whom."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass, field
from typing import NamedTuple

from day6_core.graph.endpoints import Endpoint, EndpointKind
from day6_core.graph.graph import Graph
from day6_core.graph.qos import COMPARED, incompatible_policies

ACTION = "/_action/send_goal"
"""An action is the service of that name below its own."""


class NodeAndType(NamedTuple):
    """A publisher or subscription: its node and type."""

    node: str
    type: str


@dataclass(frozen=True)
class GraphFacts:
    """The facts about a graph, without hidden nodes and topics (with `_`)."""

    publishers: Mapping[str, tuple[NodeAndType, ...]] = field(default_factory=dict)
    subscriptions: Mapping[str, tuple[NodeAndType, ...]] = field(default_factory=dict)
    nodes: tuple[str, ...] = ()
    """Full names, one for each node, so that duplicates count."""
    servers: Mapping[str, tuple[str, ...]] = field(default_factory=dict)
    """Service -> nodes that offer it; an action by its own name too."""
    clients: Mapping[str, tuple[str, ...]] = field(default_factory=dict)
    services: Mapping[str, tuple[str, ...]] = field(default_factory=dict)
    """Service -> its types, without those of actions."""
    actions: Mapping[str, tuple[str, ...]] = field(default_factory=dict)
    deaf: tuple[tuple[str, str, str, str], ...] = ()
    """Pairs with incompatible QoS: topic, publisher's node, subscriber's node, the policy."""
    domain: int = 0
    domains: Mapping[int, tuple[str, ...]] = field(default_factory=dict)
    """Domains in use here -> their nodes."""

    @property
    def topics(self) -> dict[str, tuple[str, ...]]:
        """The topics with their types."""
        ends = {name: self.ends(name) for name in sorted({*self.publishers, *self.subscriptions})}
        return {name: tuple(sorted({end.type for end in each})) for name, each in ends.items()}

    @property
    def twins(self) -> dict[str, int]:
        """How many nodes share a name, by the names that several have."""
        return {name: count for name, count in Counter(self.nodes).items() if count > 1}

    def domains_besides(self, domain: int) -> dict[int, tuple[str, ...]]:
        """Return the other domains in which nodes run, sorted, with these."""
        return {each: nodes for each, nodes in sorted(self.domains.items()) if nodes and each != domain}

    def ends(self, topic: str) -> tuple[NodeAndType, ...]:
        """Return the publishers of a topic, then its subscriptions."""
        return (*self.publishers.get(topic, ()), *self.subscriptions.get(topic, ()))


def facts_of(graph: Graph, domains: Mapping[int, Sequence[str]] | None = None) -> GraphFacts:
    """Return what a graph holds now; `domains`: the nodes of all domains that are known. Any thread."""
    publishers, subscriptions = (
        _by_topic(graph.endpoints(kind)) for kind in (EndpointKind.PUBLISHER, EndpointKind.SUBSCRIPTION)
    )
    services = graph.names_and_types(EndpointKind.SERVICE)
    return GraphFacts(
        publishers=_ends(publishers),
        subscriptions=_ends(subscriptions),
        nodes=nodes_of(graph),
        servers=_participants(graph, EndpointKind.SERVICE),
        clients=_participants(graph, EndpointKind.CLIENT),
        services={name: tuple(types) for name, types in services if "/_action/" not in name},
        actions={
            name.removesuffix(ACTION): tuple(each.removesuffix("_SendGoal") for each in types)
            for name, types in services
            if name.endswith(ACTION)
        },
        deaf=tuple(
            (topic, offer.node.full_name, request.node.full_name, policy)
            for topic, offers in publishers.items()
            for offer in offers
            for request in subscriptions.get(topic, ())
            if (policy := _incompatible_policy(offer, request))
        ),
        domain=graph.domain_id,
        domains={domain: tuple(nodes) for domain, nodes in (domains or {}).items()},
    )


def nodes_of(graph: Graph) -> tuple[str, ...]:
    """Return the full names of all nodes, one for each node."""
    return tuple(node.full_name for node in graph.nodes if not node.name.startswith("_"))


def nodes_by_domain(graphs: Iterable[Graph]) -> dict[int, tuple[str, ...]]:
    """Return the nodes of the domains of some graphs, sorted."""
    return {graph.domain_id: tuple(sorted(nodes_of(graph))) for graph in graphs}


def node_names(endpoints: Iterable[NodeAndType]) -> str:
    """Return the nodes of some endpoints, each once, as a text."""
    return ", ".join(dict.fromkeys(each.node for each in endpoints))


def is_shown(node_name: str) -> bool:
    """Whether a node counts: those of `ros2 topic pub` and `echo` are hidden, but their topic names are typed by hand."""
    return not node_name.startswith("_") or node_name.startswith("_ros2cli")


def _is_hidden(name: str) -> bool:
    return any(part.startswith("_") for part in name.split("/"))


def _by_topic(endpoints: Iterable[Endpoint]) -> dict[str, list[Endpoint]]:
    found: dict[str, list[Endpoint]] = {}
    for each in endpoints:
        if is_shown(each.node.name) and not _is_hidden(each.topic):
            found.setdefault(each.topic, []).append(each)
    return dict(sorted(found.items()))


def _ends(endpoints: Mapping[str, list[Endpoint]]) -> dict[str, tuple[NodeAndType, ...]]:
    return {
        name: tuple(NodeAndType(at.node.full_name, at.type_name) for at in each) for name, each in endpoints.items()
    }


def _incompatible_policy(offer: Endpoint, request: Endpoint) -> str:
    """The first policy for which two endpoints do not fit, '' if they do."""
    kinds = incompatible_policies(offer.qos, request.qos)
    return next((policy.name for policy in COMPARED if policy.kind in kinds), "")


def _participants(graph: Graph, kind: EndpointKind) -> dict[str, tuple[str, ...]]:
    """The services with the nodes that offer or use them, an action by its own name."""
    found: dict[str, tuple[str, ...]] = {}
    for each in graph.endpoints(kind):
        name = each.topic.removesuffix(ACTION)
        if is_shown(each.node.name) and not _is_hidden(name):
            found[name] = tuple(dict.fromkeys((*found.get(name, ()), each.node.full_name)))
    return found
