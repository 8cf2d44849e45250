"""The nodes and endpoints of other processes, added to and removed from this process's graph by their liveliness tokens.

Only the link's thread changes it. Tokens may come in any order: an endpoint's token creates its node if that is missing.
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Callable
from typing import Any, NamedTuple

from day6_core.graph.endpoints import Endpoint, EndpointKind, Publisher, Subscription
from day6_core.graph.graph import Graph
from day6_core.graph.node import Node
from day6_core.link.gid import gid_of
from day6_core.link.keys import Announcement, parse_token
from day6_core.link.limits import (
    MOST_ENDPOINTS,
    MOST_ENDPOINTS_OF_ONE,
    MOST_NODES,
    MOST_NODES_OF_ONE,
    MOST_WAITING_FOR_ROOM,
    Refusals,
)
from day6_core.link.paths import LinkError, Neighbourhood, meeting_place
from day6_core.link.unannounced import UnannouncedSenders


class Origin(NamedTuple):
    """The mark of remote nodes: the Zenoh session they live in."""

    zid: str


def lives_here(origin: object, domain_id: int) -> bool:
    """Return whether an origin is a process of this user on this machine that has a socket for the others."""
    if not isinstance(origin, Origin):
        return False
    try:
        return origin.zid in Neighbourhood(meeting_place(domain_id))
    except (LinkError, OSError):
        return False


class _RemoteNode:
    def __init__(self, node: Node) -> None:
        self.node = node
        self.announced = False
        self.endpoints: dict[str, Endpoint] = {}


class RemoteGraph:
    """Keeps the nodes and endpoints of all sessions except `own_zid` in `graph`, as many as `limits` allows.

    `is_neighbour(zid)` is whether a session is one of this user's processes on this machine: other machines cannot use up
    their share.
    """

    def __init__(self, graph: Graph, own_zid: str, refusals: Refusals, is_neighbour: Callable[[str], bool]) -> None:
        self._graph = graph
        self.own_zid = own_zid
        self._refusals = refusals
        self._is_neighbour = is_neighbour
        self._nodes_of: Counter[str] = Counter()
        self._endpoints_of: Counter[str] = Counter()
        self._endpoint_count = 0
        self._waiting: dict[str, None] = {}
        """Tokens refused because a limit was reached, oldest first."""
        self._room = False
        """Whether something has been removed since the waiting tokens were last tried."""
        self._nodes: dict[tuple[str, str], _RemoteNode] = {}
        self._publishers: dict[bytes, Publisher] = {}
        self._unannounced = UnannouncedSenders()

    def appear(self, token: str) -> None:
        """Add the node or endpoint a token announces; a known token changes nothing."""
        announcement = parse_token(token)
        if announcement is None:
            self._refusals.add("names")
            return
        if announcement.zid == self.own_zid:
            return
        known = self._nodes.get(announcement.node_key)
        is_node = announcement.kind is None
        if not is_node and known is not None and token in known.endpoints:
            return
        if not self._has_room(announcement):
            if token not in self._waiting:
                self._refusals.add("nodes" if known is None else "endpoints")
                if len(self._waiting) < MOST_WAITING_FOR_ROOM:
                    self._waiting[token] = None
            return
        if known is None:
            known = self._nodes[announcement.node_key] = _RemoteNode(self._create_node(announcement))
            self._nodes_of[announcement.zid] += 1
        if is_node:
            known.announced = True
        else:
            self._add_endpoint(known, announcement, token)

    def _add_endpoint(self, known: _RemoteNode, announcement: Announcement, token: str) -> None:
        endpoint = self._create_endpoint(known.node, announcement, gid_of(token))
        known.endpoints[token] = endpoint
        self._count_endpoints(announcement.zid, 1)
        if isinstance(endpoint, Publisher):
            self._publishers[endpoint.gid] = endpoint

    def vanish(self, token: str) -> None:
        """Remove the endpoint, or the node with its endpoints, that a token announced."""
        self._unannounced.forget_old()
        if token in self._waiting:
            del self._waiting[token]
            return
        announcement = parse_token(token)
        if announcement is None:
            return
        known = self._nodes.get(announcement.node_key)
        if known is None:
            return
        self._remove(known, announcement, token)
        self._room = True

    def _remove(self, known: _RemoteNode, announcement: Announcement, token: str) -> None:
        if announcement.kind is None:
            self._remove_node(announcement.node_key)
            return
        endpoint = known.endpoints.pop(token, None)
        if endpoint is not None:
            self._count_endpoints(announcement.zid, -1)
            self._publishers.pop(endpoint.gid, None)
            endpoint.destroy()
        if not known.announced and not known.endpoints:
            self._remove_node(announcement.node_key)

    def clear(self) -> None:
        """Remove everything."""
        self._waiting.clear()
        for key in list(self._nodes):
            self._remove_node(key)
        self._unannounced.clear()

    @property
    def has_room(self) -> bool:
        """Whether `admit_waiting` may have something to do."""
        return self._room and bool(self._waiting)

    def admit_waiting(self) -> None:
        """Add what was refused because a limit was reached, as far as there is room now. To be called periodically."""
        if not self._room:
            return
        self._room = False
        for token in list(self._waiting):
            announcement = parse_token(token)
            if announcement is not None and self._has_room(announcement):
                del self._waiting[token]
                self.appear(token)
        if not self._waiting:
            self._refusals.forget("nodes", "endpoints")

    def publisher_for(self, gid: bytes, subscription: Subscription) -> Publisher | None:
        """Return the publisher of a message for `subscription`; None when their QoS or types do not match.

        Callable from any thread. A sender whose GID is unknown (its token is still on the way, or its GIDs are not made as
        rmw_zenoh makes them) gets a placeholder that is not in the graph.
        """
        publisher = self._publishers.get(gid)
        if publisher is not None:
            return publisher if subscription in publisher.matched else None
        return self._unannounced.get((gid, subscription.topic), lambda: self._placeholder(gid, subscription))

    def _placeholder(self, gid: bytes, it: Subscription) -> Publisher:
        node = Node(self._graph, "", "/", "/", Origin(""))
        return Publisher(node, it.topic, it.type_name, it.type_hash, it.qos, gid, _same)

    def _has_room(self, announcement: Announcement) -> bool:
        if announcement.node_key not in self._nodes and self._full_of_nodes(announcement.zid):
            return False
        return announcement.kind is None or not self._full_of_endpoints(announcement.zid)

    def _full_of_nodes(self, zid: str) -> bool:
        if self._nodes_of[zid] >= MOST_NODES_OF_ONE:
            return True
        return len(self._nodes) >= MOST_NODES and not self._is_neighbour(zid)

    def _full_of_endpoints(self, zid: str) -> bool:
        if self._endpoints_of[zid] >= MOST_ENDPOINTS_OF_ONE:
            return True
        return self._endpoint_count >= MOST_ENDPOINTS and not self._is_neighbour(zid)

    def _count_endpoints(self, zid: str, change: int) -> None:
        self._endpoint_count += change
        self._endpoints_of[zid] += change
        if not self._endpoints_of[zid]:
            del self._endpoints_of[zid]

    def _create_node(self, announcement: Announcement) -> Node:
        origin = Origin(announcement.zid)
        return self._graph.create_node(
            announcement.node_name, announcement.namespace, enclave=announcement.enclave, origin=origin
        )

    @staticmethod
    def _create_endpoint(node: Node, it: Announcement, gid: bytes) -> Endpoint:
        # The link delivers their messages itself, deserialized for each receiver: nothing to copy.
        if it.kind == EndpointKind.PUBLISHER:
            return node.create_publisher(it.topic, it.type_name, it.type_hash, it.qos, _same, gid=gid)
        if it.kind == EndpointKind.SUBSCRIPTION:
            return node.create_subscription(it.topic, it.type_name, it.type_hash, it.qos, gid=gid)
        if it.kind == EndpointKind.SERVICE:
            return node.create_service(it.topic, it.type_name, it.type_hash, it.qos, _same, gid=gid)
        return node.create_client(it.topic, it.type_name, it.type_hash, it.qos, _same, gid=gid)

    def _remove_node(self, key: tuple[str, str]) -> None:
        known = self._nodes.pop(key)
        zid, _ = key
        self._nodes_of[zid] -= 1
        if not self._nodes_of[zid]:
            del self._nodes_of[zid]
        if known.endpoints:
            self._count_endpoints(zid, -len(known.endpoints))
        for endpoint in known.endpoints.values():
            self._publishers.pop(endpoint.gid, None)
        known.node.destroy()


def _same(message: Any) -> Any:
    return message
