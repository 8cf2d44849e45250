"""What exists in other processes, put into this process's graph as their liveliness tokens come and go.

Only the link's thread changes it. Tokens may come in any order: an endpoint's before its node's makes the node.
"""

from __future__ import annotations

from typing import Any, NamedTuple

from day6_tui.core.graph.endpoints import Endpoint, EndpointKind, Publisher, Subscription
from day6_tui.core.graph.graph import Graph
from day6_tui.core.graph.node import Node
from day6_tui.core.link.gid import gid_of
from day6_tui.core.link.keys import Announcement, parse_token
from day6_tui.core.link.paths import LinkError, meeting_place, neighbours


class Origin(NamedTuple):
    """The mark of remote nodes: the Zenoh session they live in."""

    zid: str


def lives_here(origin: object, domain_id: int) -> bool:
    """Say whether what has this origin is in a process of this user on this machine that keeps a socket for the others."""
    if not isinstance(origin, Origin):
        return False
    try:
        return any(each.zid == origin.zid for each in neighbours(meeting_place(domain_id)))
    except (LinkError, OSError):
        return False


class _RemoteNode:
    def __init__(self, node: Node) -> None:
        self.node = node
        self.announced = False
        self.endpoints: dict[str, Endpoint] = {}


class RemoteGraph:
    """Keeps the nodes and endpoints of all sessions but `own_zid` in `graph`."""

    def __init__(self, graph: Graph, own_zid: str) -> None:
        self._graph = graph
        self._own_zid = own_zid
        self._nodes: dict[tuple[str, str], _RemoteNode] = {}
        self._publishers: dict[bytes, Publisher] = {}
        self._strangers: dict[tuple[bytes, str], Publisher] = {}
        self.refused = 0
        """Tokens that announced nothing ROS could have: wrong names, types, hashes or QoS."""

    def appear(self, token: str) -> None:
        """Add what a token announces; a token seen before changes nothing."""
        announcement = parse_token(token)
        if announcement is None:
            self.refused += 1
            return
        if announcement.zid == self._own_zid:
            return
        known = self._nodes.get(announcement.node_key)
        if known is None:
            known = self._nodes[announcement.node_key] = _RemoteNode(self._create_node(announcement))
        if announcement.kind is None:
            known.announced = True
        elif token not in known.endpoints:
            endpoint = self._create_endpoint(known.node, announcement, gid_of(token))
            known.endpoints[token] = endpoint
            if isinstance(endpoint, Publisher):
                self._publishers[endpoint.gid] = endpoint

    def vanish(self, token: str) -> None:
        """Remove what a token announced; with a node go its endpoints."""
        announcement = parse_token(token)
        if announcement is None:
            return
        known = self._nodes.get(announcement.node_key)
        if known is None:
            return
        if announcement.kind is None:
            self._remove_node(announcement.node_key)
            return
        endpoint = known.endpoints.pop(token, None)
        if endpoint is not None:
            self._publishers.pop(endpoint.gid, None)
            endpoint.destroy()
        if not known.announced and not known.endpoints:
            self._remove_node(announcement.node_key)

    def clear(self) -> None:
        """Remove everything."""
        for key in list(self._nodes):
            self._remove_node(key)
        self._strangers.clear()

    def publisher_for(self, gid: bytes, subscription: Subscription) -> Publisher | None:
        """Return who sent a message to `subscription`; None when their QoS or types do not match.

        Callable from any thread. Whoever is not known by its GID (its token is still on the way, or it makes its GIDs
        in another way than rmw_zenoh) gets a stand-in that is not in the graph.
        """
        publisher = self._publishers.get(gid)
        if publisher is not None:
            return publisher if subscription in publisher.matched else None
        key = (gid, subscription.topic)
        stranger = self._strangers.get(key)
        if stranger is None:
            node = Node(self._graph, "", "/", "/", Origin(""))
            stranger = Publisher(
                node, subscription.topic, subscription.type_name, subscription.type_hash, subscription.qos, gid, _same
            )
            self._strangers[key] = stranger
        return stranger

    def _create_node(self, announcement: Announcement) -> Node:
        origin = Origin(announcement.zid)
        return self._graph.create_node(
            announcement.node_name, announcement.namespace, enclave=announcement.enclave, origin=origin
        )

    @staticmethod
    def _create_endpoint(node: Node, it: Announcement, gid: bytes) -> Endpoint:
        # The link itself hands their messages on, made from bytes for each receiver: nothing to copy.
        if it.kind == EndpointKind.PUBLISHER:
            return node.create_publisher(it.topic, it.type_name, it.type_hash, it.qos, _same, gid=gid)
        if it.kind == EndpointKind.SUBSCRIPTION:
            return node.create_subscription(it.topic, it.type_name, it.type_hash, it.qos, gid=gid)
        if it.kind == EndpointKind.SERVICE:
            return node.create_service(it.topic, it.type_name, it.type_hash, it.qos, _same, gid=gid)
        return node.create_client(it.topic, it.type_name, it.type_hash, it.qos, _same, gid=gid)

    def _remove_node(self, key: tuple[str, str]) -> None:
        known = self._nodes.pop(key)
        for endpoint in known.endpoints.values():
            self._publishers.pop(endpoint.gid, None)
        known.node.destroy()


def _same(message: Any) -> Any:
    return message
