"""The graph itself: its nodes and endpoints, their matching, and the listeners for changes."""

from __future__ import annotations

import os
import threading
import time
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from enum import Enum
from itertools import count
from typing import Any, NamedTuple, Protocol, TypeVar

from day6_core.graph.endpoints import Client, Endpoint, EndpointKind, EventKind, Publisher, RequestId, Service
from day6_core.graph.matching import MATCHES, RaisedEvents, connect, disconnect, without
from day6_core.graph.node import Node

AnyEndpoint = TypeVar("AnyEndpoint", bound=Endpoint)


class Transport(Protocol):
    """Carries messages to the endpoints of other processes (day6_core/link)."""

    def publish(self, publisher: Publisher, message: Any, source_timestamp: int, number: int) -> None:
        """Send a message of a local publisher to its remote subscriptions."""

    def send_request(self, client: Client, request: Any, number: int) -> None:
        """Send a request of a local client to the remote servers."""

    def send_response(self, service: Service, request_id: RequestId, response: Any) -> None:
        """Send the response of a local server to a remote client."""

    def wait_settled(self, timeout: float) -> bool:
        """Wait until the graph knows what the other processes have announced; False if `timeout` seconds passed first."""


class Change(Enum):
    """The kinds of graph event."""

    NODE_ADDED = "node added"
    NODE_REMOVED = "node removed"
    ENDPOINT_ADDED = "endpoint added"
    ENDPOINT_REMOVED = "endpoint removed"


class GraphEvent(NamedTuple):
    """One change of the graph; `subject` is the node or endpoint."""

    change: Change
    subject: Node | Endpoint


Listener = Callable[[GraphEvent], None]


class Graph:
    """The nodes and endpoints of one ROS domain, those of this process and, through the link, those of others.

    Nodes that only look on (`Node.is_observer`) and their endpoints get what is sent, but no query names or counts them.
    Listeners hear of them, because the link announces them: there their names hide them too.

    Thread-safe. Listeners and endpoint callbacks run on the thread that made the change, after the lock is released.
    `now_ns` returns the time for timestamps of messages (epoch ns). The link sets `transport`, and `identify`, which returns
    the GID (16 bytes) by which other processes know an endpoint.
    """

    def __init__(self, domain_id: int = 0) -> None:
        self.domain_id = domain_id
        self.now_ns: Callable[[], int] = time.time_ns
        self.transport: Transport | None = None
        self.identify: Callable[[Endpoint], bytes] = lambda _: self.new_gid()
        self.report_process: Callable[[], bytes] | None = None
        """What this process tells another one of this user that asks (`day6_core/link/process_reports`); rclpy sets it."""
        self._lock = threading.RLock()
        self._nodes: tuple[Node, ...] = ()
        self._observers: tuple[Node, ...] = ()
        self._by_name: dict[tuple[EndpointKind, str], list[Endpoint]] = {}
        self._listeners: tuple[Listener, ...] = ()
        self._entity_ids = count(1)
        self._gid_prefix = os.urandom(12)
        self._gid_numbers = count(1)
        self._pending: list[Callable[[], None]] = []
        self._depth = 0

    # -- identity ------------------------------------------------------------------------------------------------------

    def next_entity_id(self) -> int:
        """Return a number that no other node or endpoint of this graph has."""
        return next(self._entity_ids)

    def new_gid(self) -> bytes:
        """Return 16 bytes that identify one endpoint among all processes."""
        return self._gid_prefix + next(self._gid_numbers).to_bytes(4, "big")

    def assign_gid(self, endpoint: Endpoint) -> bytes:
        """Create the GID of an endpoint, on first access, and return it."""
        with self._lock:
            if endpoint._gid is None:
                endpoint._gid = self.identify(endpoint)
            return endpoint._gid

    def renew_gids(self) -> None:
        """Let this process's endpoints get other GIDs, on the next access."""
        with self._lock:
            for node in (*self.nodes, *self.observers):
                if node.origin is None:
                    for endpoint in node.endpoints:
                        endpoint._gid = None

    def renew_lock(self) -> None:
        """In a forked child: create a lock that no thread of the parent holds."""
        self._lock = threading.RLock()
        self._depth = 0

    # -- changes -------------------------------------------------------------------------------------------------------

    @contextmanager
    def _changing(self) -> Iterator[None]:
        """Hold the lock; make the pending calls (listeners, callbacks) when the outermost change is complete."""
        calls: list[Callable[[], None]] = []
        with self._lock:
            self._depth += 1
            try:
                yield
            finally:
                self._depth -= 1
                if self._depth == 0:
                    calls, self._pending = self._pending, []
        for call in calls:
            try:
                call()
            except Exception:
                # The change has been made, and those after this one have to hear of it.
                import logging

                logging.getLogger(__name__).exception("a listener of the graph failed")

    def _announce(self, change: Change, subject: Node | Endpoint) -> None:
        event = GraphEvent(change, subject)
        for listener in self._listeners:
            self._pending.append(lambda listener=listener: listener(event))  # type: ignore[misc]

    def add_listener(self, listener: Listener) -> Callable[[], None]:
        """Call `listener` on every change from now on; returns a function that removes it."""
        with self._lock:
            self._listeners = (*self._listeners, listener)

        def remove() -> None:
            with self._lock:
                self._listeners = tuple(each for each in self._listeners if each is not listener)

        return remove

    def create_node(
        self,
        name: str,
        namespace: str = "/",
        *,
        enclave: str = "/",
        origin: object | None = None,
        program: object | None = None,
    ) -> Node:
        """Add a node. Names are not checked (rclpy validates and remaps them first); several nodes may share a name."""
        node = Node(self, name, namespace, enclave, origin, program)
        with self._changing():
            if node.is_observer:
                self._observers = (*self._observers, node)
            else:
                self._nodes = (*self._nodes, node)
            self._announce(Change.NODE_ADDED, node)
        return node

    def remove_node(self, node: Node) -> None:
        """Remove a node with its endpoints; a second call does nothing."""
        with self._changing():
            if node.destroyed:
                return
            for endpoint in node.endpoints:
                self.remove_endpoint(endpoint)
            node.destroyed = True
            if node.is_observer:
                self._observers = without(self._observers, node)
            else:
                self._nodes = without(self._nodes, node)
            self._announce(Change.NODE_REMOVED, node)

    def add_endpoint(self, endpoint: AnyEndpoint) -> AnyEndpoint:
        """Add an endpoint and match it (the `create_*` methods of Node call this)."""
        with self._changing():
            endpoint.node.endpoints = (*endpoint.node.endpoints, endpoint)
            raised: RaisedEvents = []
            connect(endpoint, tuple(self._by_name.get((MATCHES[endpoint.kind], endpoint.topic), ())), raised)
            self._by_name.setdefault((endpoint.kind, endpoint.topic), []).append(endpoint)
            self._notify_later(raised)
            self._announce(Change.ENDPOINT_ADDED, endpoint)
        return endpoint

    def remove_endpoint(self, endpoint: Endpoint) -> None:
        """Remove an endpoint; a second call does nothing."""
        with self._changing():
            if endpoint.destroyed:
                return
            endpoint.destroyed = True
            node = endpoint.node
            node.endpoints = without(node.endpoints, endpoint)
            key = endpoint.kind, endpoint.topic
            peers = self._by_name[key]
            peers.remove(endpoint)
            raised: RaisedEvents = []
            disconnect(endpoint, raised)
            self._notify_later(raised)
            if not peers:
                # Gone already if a garbage collection in the middle of this removed the last other endpoint.
                self._by_name.pop(key, None)
            self._announce(Change.ENDPOINT_REMOVED, endpoint)

    def _notify_later(self, raised: RaisedEvents) -> None:
        """Schedule the callbacks of endpoints for when the lock is released."""
        for endpoint, kind in raised:

            def call(endpoint: Endpoint = endpoint, kind: EventKind = kind) -> None:
                if endpoint.on_event is not None:
                    endpoint.on_event(endpoint, kind)

            self._pending.append(call)

    # -- queries -------------------------------------------------------------------------------------------------------

    @property
    def nodes(self) -> tuple[Node, ...]:
        """All nodes, in order of creation."""
        return self._nodes

    @property
    def observers(self) -> tuple[Node, ...]:
        """The nodes that only look on, in order of creation."""
        return self._observers

    def find_nodes(self, name: str, namespace: str) -> list[Node]:
        """Return the nodes with a name and namespace (several may share them)."""
        return [node for node in self._nodes if node.name == name and node.namespace == namespace]

    def endpoints(self, *kinds: EndpointKind, topic: str | None = None) -> list[Endpoint]:
        """Return the endpoints of some kinds, on all topics or on one."""
        with self._lock:
            if topic is None:
                groups = [peers for (kind, _), peers in self._by_name.items() if kind in kinds]
            else:
                groups = [self._by_name.get((kind, topic), []) for kind in kinds]
            return [endpoint for peers in groups for endpoint in peers if not endpoint.node.is_observer]

    def names_and_types(self, *kinds: EndpointKind) -> list[tuple[str, list[str]]]:
        """Return `(full name, sorted type names)` of the endpoints of some kinds, sorted by name."""
        return _names_and_types(self.endpoints(*kinds))

    def names_and_types_by_node(self, node: Node, kind: EndpointKind) -> list[tuple[str, list[str]]]:
        """Return `(full name, sorted type names)` of one node's endpoints of one kind, sorted by name."""
        return _names_and_types([endpoint for endpoint in node.endpoints if endpoint.kind == kind])


def _names_and_types(endpoints: list[Endpoint]) -> list[tuple[str, list[str]]]:
    found: dict[str, set[str]] = {}
    for endpoint in endpoints:
        found.setdefault(endpoint.topic, set()).add(endpoint.type_name)
    return [(name, sorted(types)) for name, types in sorted(found.items())]


_graphs: dict[int, Graph] = {}
_graphs_lock = threading.Lock()


def graph_for_domain(domain_id: int) -> Graph:
    """Return this process's graph of a domain, created on first use."""
    with _graphs_lock:
        return _graphs.setdefault(domain_id, Graph(domain_id))
