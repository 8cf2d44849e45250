"""A node's view of the graph: nodes, topics, services, counts, endpoints."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from day6_core.graph import Endpoint, EndpointKind, Graph
from day6_core.graph import Node as GraphNode
from day6_core.graph import names as graph_names
from rclpy._day6.handles import rules_for
from rclpy._day6.resolve import raise_for_topic
from rclpy._rclpy_pybind11 import NodeNameNonExistentError, RCLError
from rclpy.expand_topic_name import expand_topic_name

if TYPE_CHECKING:
    from rclpy._day6.handles import NodeHandle
    from rclpy.endpoint_info import ServiceEndpointInfo
    from rclpy.topic_endpoint_info import TopicEndpointInfo

NamesAndTypes = list[tuple[str, list[str]]]
_GID_LENGTH = 16


class NodeGraph:
    """The graph as one node sees it: relative names belong to its namespace, and a destroyed node sees nothing."""

    def __init__(self, handle: NodeHandle) -> None:
        self._handle = handle
        self._graph: Graph = handle.node.graph

    # -- of one node ---------------------------------------------------------------------------------------------------

    def _by_node(self, kind: EndpointKind, what: str, node_name: str, node_namespace: str) -> NamesAndTypes:
        failed = f"failed to get {what} names and types"
        self._handle.check_valid(failed)
        for flaw, line in (
            (graph_names.flaw_of_namespace(node_namespace or "/"), 57),
            (graph_names.flaw_of_node_name(node_name), 69),
        ):
            if flaw is not None:
                raise RCLError(f"{failed}: {flaw.message}, result: {flaw.number}, at /project/src/rcl/graph.c:{line}")
        nodes = self._graph.find_nodes(node_name, node_namespace or "/")
        if not nodes:
            raise NodeNameNonExistentError(f"cannot get {what} names and types for nonexistent node: error not set")
        found: dict[str, set[str]] = {}
        for node in nodes:
            for name, types in self._graph.names_and_types_by_node(node, kind):
                found.setdefault(name, set()).update(types)
        return [(name, sorted(types)) for name, types in sorted(found.items())]

    def get_publisher_names_and_types_by_node(
        self, node_name: str, node_namespace: str, no_demangle: bool = False
    ) -> NamesAndTypes:
        """Return the topics a node publishes, with types. NodeNameNonExistentError if it is unknown, RCLError for bad names."""
        found = self._by_node(EndpointKind.PUBLISHER, "publisher", node_name, node_namespace)
        return self._mangled_by_node(found, "publisher", node_name, node_namespace) if no_demangle else found

    def get_subscriber_names_and_types_by_node(
        self, node_name: str, node_namespace: str, no_demangle: bool = False
    ) -> NamesAndTypes:
        """Return the topics a node subscribes to, with types; raises as `get_publisher_names_and_types_by_node`."""
        found = self._by_node(EndpointKind.SUBSCRIPTION, "subscriber", node_name, node_namespace)
        return self._mangled_by_node(found, "subscriber", node_name, node_namespace) if no_demangle else found

    def _mangled_by_node(self, topics: NamesAndTypes, what: str, name: str, namespace: str) -> NamesAndTypes:
        """Return topics under their DDS names, where a service is two topics, one for requests and one for replies."""
        servers = self._by_node(EndpointKind.SERVICE, what, name, namespace)
        clients = self._by_node(EndpointKind.CLIENT, what, name, namespace)
        asking, answering = (clients, servers) if what == "publisher" else (servers, clients)
        return sorted(_mangled(topics) + _mangled_parts(asking, "Request") + _mangled_parts(answering, "Reply"))

    def get_service_names_and_types_by_node(self, node_name: str, node_namespace: str) -> NamesAndTypes:
        """Return the services a node serves; raises as `get_publisher_names_and_types_by_node`."""
        return self._by_node(EndpointKind.SERVICE, "service", node_name, node_namespace)

    def get_client_names_and_types_by_node(self, node_name: str, node_namespace: str) -> NamesAndTypes:
        """Return the services a node is a client of; raises as `get_publisher_names_and_types_by_node`."""
        return self._by_node(EndpointKind.CLIENT, "client", node_name, node_namespace)

    # -- actions, which are known by their feedback topics, as in rcl_action --------------------------------------------

    def _actions_by_node(self, kind: EndpointKind, what: str, name: str, namespace: str) -> NamesAndTypes:
        failed = f"Failed to get action {what} names and type"
        self._handle.check_valid(failed)
        nodes = self._graph.find_nodes(name, namespace)
        if not nodes:
            raise RCLError(f"{failed}: error not set")
        found: dict[str, list[str]] = {}
        for node in nodes:
            found.update(self._graph.names_and_types_by_node(node, kind))
        return _actions(sorted(found.items()))

    def get_action_client_names_and_types_by_node(self, node_name: str, node_namespace: str) -> NamesAndTypes:
        """Return the actions a node is a client of. RCLError if there is no such node."""
        return self._actions_by_node(EndpointKind.SUBSCRIPTION, "client", node_name, node_namespace)

    def get_action_server_names_and_types_by_node(self, node_name: str, node_namespace: str) -> NamesAndTypes:
        """Return the actions a node serves. RCLError if there is no such node."""
        return self._actions_by_node(EndpointKind.PUBLISHER, "server", node_name, node_namespace)

    def get_action_names_and_types(self) -> NamesAndTypes:
        """Return all actions with their types."""
        return _actions(self.get_topic_names_and_types())

    # -- of all --------------------------------------------------------------------------------------------------------

    def get_topic_names_and_types(self, no_demangle: bool = False) -> NamesAndTypes:
        """Return all topics with their types."""
        self._handle.check_valid("failed to get topic names and types")
        found = self._graph.names_and_types(EndpointKind.PUBLISHER, EndpointKind.SUBSCRIPTION)
        if not no_demangle:
            return found
        services = self.get_service_names_and_types()
        own = [("ros_discovery_info", ["rmw_dds_common::msg::dds_::ParticipantEntitiesInfo_"])]
        return sorted(own + _mangled(found) + _mangled_parts(services, "Request") + _mangled_parts(services, "Reply"))

    def get_service_names_and_types(self) -> NamesAndTypes:
        """Return all services with their types."""
        self._handle.check_valid("failed to get service names and types")
        return self._graph.names_and_types(EndpointKind.SERVICE, EndpointKind.CLIENT)

    def _nodes(self) -> tuple[GraphNode, ...]:
        self._handle.check_valid("Failed to get node names")
        return self._graph.nodes

    def get_node_names(self) -> list[str]:
        """Return the names of all nodes, without namespaces."""
        return [node.name for node in self._nodes()]

    def get_fully_qualified_node_names(self) -> list[str]:
        """Return the full names of all nodes."""
        return [node.full_name for node in self._nodes()]

    def get_node_names_and_namespaces(self) -> list[tuple[str, str]]:
        """Return (name, namespace) of all nodes."""
        return [(node.name, node.namespace) for node in self._nodes()]

    def get_node_names_and_namespaces_with_enclaves(self) -> list[tuple[str, str, str]]:
        """Return (name, namespace, enclave) of all nodes."""
        return [(node.name, node.namespace, node.enclave) for node in self._nodes()]

    # -- counts --------------------------------------------------------------------------------------------------------

    def _count_endpoints(self, name: str, kind: EndpointKind, what: str) -> int:
        self._handle.check()
        full = expand_topic_name(name, self._handle.name, self._handle.namespace)
        service = kind in (EndpointKind.CLIENT, EndpointKind.SERVICE)
        raise_for_topic(graph_names.flaw_of_full_topic_name(full), full, is_service=service)
        self._handle.check_valid(f"Error in rcl_count_{what}")
        return len(self._graph.endpoints(kind, topic=full))

    def count_publishers(self, topic_name: str) -> int:
        """Return the number of publishers of a topic (relative names belong to the node's namespace; no remapping)."""
        return self._count_endpoints(topic_name, EndpointKind.PUBLISHER, "publishers")

    def count_subscribers(self, topic_name: str) -> int:
        """Return the number of subscriptions of a topic."""
        return self._count_endpoints(topic_name, EndpointKind.SUBSCRIPTION, "subscribers")

    def count_clients(self, service_name: str) -> int:
        """Return the number of clients of a service."""
        return self._count_endpoints(service_name, EndpointKind.CLIENT, "clients")

    def count_services(self, service_name: str) -> int:
        """Return the number of servers of a service."""
        return self._count_endpoints(service_name, EndpointKind.SERVICE, "services")

    # -- endpoints -----------------------------------------------------------------------------------------------------

    def _infos(self, topic_name: str, no_mangle: bool, kind: EndpointKind, what: str) -> list[TopicEndpointInfo]:
        handle = self._handle
        handle.check()
        topic = topic_name
        if no_mangle:
            topic = topic_name.removeprefix("rt") if topic_name.startswith("rt/") else ""
        else:
            topic = expand_topic_name(topic_name, handle.name, handle.namespace)
            raise_for_topic(graph_names.flaw_of_full_topic_name(topic), topic)
            topic = graph_names.remap_topic(topic, handle.name, handle.namespace, handle.rules)
        handle.check_valid(f"Failed to get information by topic for {what}")
        infos = [_info(endpoint) for endpoint in self._graph.endpoints(kind, topic=topic)]
        if no_mangle:
            for info in infos:
                info.topic_type = mangled_type(info.topic_type)
        return infos

    def get_publishers_info_by_topic(self, topic_name: str, no_mangle: bool = False) -> list[TopicEndpointInfo]:
        """Return the publishers of a topic: node, type, GID, QoS."""
        return self._infos(topic_name, no_mangle, EndpointKind.PUBLISHER, "publishers")

    def get_subscriptions_info_by_topic(self, topic_name: str, no_mangle: bool = False) -> list[TopicEndpointInfo]:
        """Return the subscriptions of a topic: node, type, GID, QoS."""
        return self._infos(topic_name, no_mangle, EndpointKind.SUBSCRIPTION, "subscriptions")

    def _service_infos(self, name: str, no_mangle: bool, kind: EndpointKind, what: str) -> list[ServiceEndpointInfo]:
        handle = self._handle
        handle.check()
        service = ""
        if not no_mangle:
            service = expand_topic_name(name, handle.name, handle.namespace)
            raise_for_topic(graph_names.flaw_of_full_topic_name(service), service, is_service=True)
            service = graph_names.remap_topic(service, handle.name, handle.namespace, rules_for(handle.rules, True))
        handle.check_valid(f"Failed to get information by service for {what}")
        return [_service_info(endpoint) for endpoint in self._graph.endpoints(kind, topic=service)]

    def get_clients_info_by_service(self, service_name: str, no_mangle: bool = False) -> list[ServiceEndpointInfo]:
        """Return the clients of a service: node, type, GIDs, QoS."""
        return self._service_infos(service_name, no_mangle, EndpointKind.CLIENT, "clients")

    def get_servers_info_by_service(self, service_name: str, no_mangle: bool = False) -> list[ServiceEndpointInfo]:
        """Return the servers of a service: node, type, GIDs, QoS."""
        return self._service_infos(service_name, no_mangle, EndpointKind.SERVICE, "servers")

    # -- waiting -------------------------------------------------------------------------------------------------------

    def wait_for_node(self, fully_qualified_node_name: str, timeout: float) -> bool:
        """Block until a node exists, at most `timeout` seconds; returns whether it does."""
        name = fully_qualified_node_name
        if not name.startswith("/"):
            name = f"/{name}"
        if timeout <= 0:
            return False
        return self._handle.context._wait_for_graph(lambda: name in self.get_fully_qualified_node_names(), timeout)


_FEEDBACK = "/_action/feedback"
_MESSAGE = "_FeedbackMessage"


def _actions(topics: NamesAndTypes) -> NamesAndTypes:
    return [
        (name.removesuffix(_FEEDBACK), [each.removesuffix(_MESSAGE) for each in types])
        for name, types in topics
        if name.endswith(_FEEDBACK)
    ]


def _mangled(topics: NamesAndTypes) -> NamesAndTypes:
    return [(f"rt{name}", [mangled_type(type_name) for type_name in types]) for name, types in topics]


def _mangled_parts(services: NamesAndTypes, part: str) -> NamesAndTypes:
    prefix, suffix = ("rq", "Request") if part == "Request" else ("rr", "Response")
    return [
        (f"{prefix}{name}{part}", [f"{mangled_type(type_name)}{suffix}_" for type_name in types])
        for name, types in services
    ]


def mangled_type(type_name: str) -> str:
    """Return a type's DDS name: `std_msgs::msg::dds_::String_`."""
    package, kind, name = type_name.split("/")
    return f"{package}::{kind}::dds_::{name}_"


def _info(endpoint: Endpoint) -> TopicEndpointInfo:
    from rclpy.qos import QoSProfile
    from rclpy.topic_endpoint_info import TopicEndpointInfo, TopicEndpointTypeEnum

    return TopicEndpointInfo(
        node_name=endpoint.node.name,
        node_namespace=endpoint.node.namespace,
        topic_type=endpoint.type_name,
        topic_type_hash=_type_hash(endpoint.type_hash),
        endpoint_type=(
            TopicEndpointTypeEnum.PUBLISHER
            if endpoint.kind == EndpointKind.PUBLISHER
            else TopicEndpointTypeEnum.SUBSCRIPTION
        ),
        endpoint_gid=list(endpoint.gid.ljust(_GID_LENGTH, b"\0")),
        qos_profile=QoSProfile._from_graph(endpoint.qos, known_history=False),
    )


_LAST_OF_GID = (4, 3)
"""The last number of the GIDs of a reader and a writer in Fast DDS, where a client or server has one of each."""


def _service_info(endpoint: Endpoint) -> ServiceEndpointInfo:
    from rclpy.endpoint_info import EndpointTypeEnum, ServiceEndpointInfo
    from rclpy.qos import QoSProfile

    gid = endpoint.gid.ljust(_GID_LENGTH, b"\0")
    own = (*gid[:12], *gid[13:])
    profile = QoSProfile._from_graph(endpoint.qos, known_history=True)
    is_client = endpoint.kind == EndpointKind.CLIENT
    return ServiceEndpointInfo(
        node_name=endpoint.node.name,
        node_namespace=endpoint.node.namespace,
        service_type=endpoint.type_name,
        service_type_hash=_type_hash(endpoint.type_hash),
        qos_profiles=[profile, profile],
        endpoint_gids=[[*own, last] for last in _LAST_OF_GID],
        endpoint_type=EndpointTypeEnum.CLIENT if is_client else EndpointTypeEnum.SERVER,
        endpoint_count=len(_LAST_OF_GID),
    )


def _type_hash(text: str) -> Any:
    from rclpy.type_hash import TypeHash

    version, _, digits = text.partition("_")
    if not version.startswith("RIHS") or len(digits) != 64:
        return TypeHash()
    return TypeHash(int(version[4:]), bytes.fromhex(digits))
