"""Nodes of the graph: a name, a namespace and the endpoints made under it."""

from __future__ import annotations

from collections.abc import Callable
from typing import TYPE_CHECKING

from day6_core.graph.endpoints import Client, Copier, Endpoint, Publisher, Service, Subscription
from day6_core.graph.names import full_name, is_observer
from day6_core.graph.qos import QoS

if TYPE_CHECKING:
    from day6_core.graph.graph import Graph


class Node:
    """A node: a name, a namespace and its endpoints. The `create_*` methods take full names."""

    def __init__(
        self,
        graph: Graph,
        name: str,
        namespace: str,
        enclave: str,
        origin: object | None,
        program: object | None = None,
    ) -> None:
        self.graph = graph
        self.name = name
        self.namespace = namespace
        self.enclave = enclave
        self.origin = origin
        self.program = program
        """Stands for the program that made it, where several run in this process; None where this process is the program."""
        self.entity_id = graph.next_entity_id()
        self.endpoints: tuple[Endpoint, ...] = ()
        self.destroyed = False
        self.is_observer = is_observer(name)
        """Whether it only looks on (`names.OBSERVER_PREFIX`)."""

    @property
    def full_name(self) -> str:
        """Namespace and name, like `/turtlesim` or `/team/talker`."""
        return full_name(self.namespace, self.name)

    def create_publisher(
        self, topic: str, type_name: str, type_hash: str, qos: QoS, copy: Copier, *, gid: bytes | None = None
    ) -> Publisher:
        """Add a publisher of `topic`; `copy` must return an independent copy of a message, `gid` has 16 bytes."""
        return self.graph.add_endpoint(Publisher(self, topic, type_name, type_hash, qos, gid, copy))

    def create_subscription(
        self,
        topic: str,
        type_name: str,
        type_hash: str,
        qos: QoS,
        *,
        gid: bytes | None = None,
        on_ready: Callable[[Subscription], None] | None = None,
    ) -> Subscription:
        """Add a subscription to `topic`; on return its queue has the messages kept by transient-local publishers."""
        subscription = Subscription(self, topic, type_name, type_hash, qos, gid)
        subscription.on_ready = on_ready
        return self.graph.add_endpoint(subscription)

    def create_service(
        self, name: str, type_name: str, type_hash: str, qos: QoS, copy_response: Copier, *, gid: bytes | None = None
    ) -> Service:
        """Add a server of the service `name`."""
        return self.graph.add_endpoint(Service(self, name, type_name, type_hash, qos, gid, copy_response))

    def create_client(
        self, name: str, type_name: str, type_hash: str, qos: QoS, copy_request: Copier, *, gid: bytes | None = None
    ) -> Client:
        """Add a client of the service `name`."""
        return self.graph.add_endpoint(Client(self, name, type_name, type_hash, qos, gid, copy_request))

    def destroy(self) -> None:
        """Remove the node and all its endpoints from the graph; a second call does nothing."""
        self.graph.remove_node(self)
