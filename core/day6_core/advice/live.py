"""The facts of a live graph that cards ask for. Any thread."""

from __future__ import annotations

from collections.abc import Iterable

from day6_core.graph.endpoints import EndpointKind
from day6_core.graph.graph import Graph
from day6_core.graph.names import full_name


def _nodes_of(graph: Graph) -> list[str]:
    return [full_name(node.namespace, node.name) for node in graph.nodes if not node.name.startswith("_")]


class LiveGraph:
    """A graph as `GraphFacts`."""

    def __init__(self, graph: Graph, others: Iterable[Graph] = ()) -> None:
        self._graph = graph
        self._others = [other for other in others if other is not graph]

    def nodes(self) -> list[str]:
        """See GraphFacts."""
        return _nodes_of(self._graph)

    def elsewhere(self) -> dict[int, list[str]]:
        """See GraphFacts."""
        return {other.domain_id: nodes for other in self._others if (nodes := _nodes_of(other))}

    def topics(self) -> dict[str, list[str]]:
        """See GraphFacts."""
        both = self._graph.names_and_types(EndpointKind.PUBLISHER, EndpointKind.SUBSCRIPTION)
        return {name: types for name, types in both if "/_" not in name}

    def services(self) -> dict[str, list[str]]:
        """See GraphFacts."""
        return dict(self._graph.names_and_types(EndpointKind.SERVICE))

    def publishers(self, topic: str) -> list[tuple[str, str]]:
        """See GraphFacts."""
        return self._endpoints(EndpointKind.PUBLISHER, topic)

    def subscriptions(self, topic: str) -> list[tuple[str, str]]:
        """See GraphFacts."""
        return self._endpoints(EndpointKind.SUBSCRIPTION, topic)

    def _endpoints(self, kind: EndpointKind, topic: str) -> list[tuple[str, str]]:
        return [
            (full_name(endpoint.node.namespace, endpoint.node.name), endpoint.qos.reliability.name.lower())
            for endpoint in self._graph.endpoints(kind, topic=topic)
        ]
