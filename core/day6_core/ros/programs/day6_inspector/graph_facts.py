"""Reads the graph for the inspector: whose endpoints are shown, who cannot hear whom, who offers and who uses services."""

from __future__ import annotations

from collections.abc import Mapping
from typing import TYPE_CHECKING, Any

from day6_core.graph.endpoints import EndpointKind
from day6_core.graph.names import full_name
from day6_core.ros.programs.day6_inspector.facts import Endpoint
from rclpy.qos import QoSCompatibility, QoSProfile, qos_check_compatible

if TYPE_CHECKING:
    from day6_core.graph.graph import Graph

ACTION = "/_action/send_goal"
_POLICIES = {
    "reliab": "reliability",
    "volatile": "durability",
    "transient": "durability",
    "deadline": "deadline",
    "liveliness": "liveliness",
}
"""Words of rmw's reasons -> the policy they are about."""


def is_shown(node_name: str) -> bool:
    """Whether a node counts: those of `ros2 topic pub` and `echo` are hidden, but their topic names are typed by hand."""
    return not node_name.startswith("_") or node_name.startswith("_ros2cli")


def shown(infos: list[Any]) -> list[Any]:
    """Leave out the endpoints of hidden nodes."""
    return [info for info in infos if is_shown(info.node_name)]


def endpoint(info: Any) -> Endpoint:
    """Return the fact about an endpoint."""
    return Endpoint(full_name(info.node_namespace, info.node_name), info.topic_type)


def deaf_pairs(topic: str, offers: list[Any], requests: list[Any]) -> list[tuple[str, str, str, str]]:
    """Return the publishers and subscriptions of a topic whose QoS are incompatible: topic, nodes, the policy."""
    return [
        (topic, endpoint(offer).node, endpoint(request).node, _policy(offer.qos_profile, request.qos_profile))
        for offer in offers
        for request in requests
        if qos_check_compatible(offer.qos_profile, request.qos_profile)[0] == QoSCompatibility.ERROR
    ]


def _policy(offer: QoSProfile, request: QoSProfile) -> str:
    """Name the incompatible policy, as DDS compares them."""
    text = qos_check_compatible(offer, request)[1]
    return next((policy for word, policy in _POLICIES.items() if word in text.lower()), "QoS")


def participants(graph: Graph | None, kind: EndpointKind) -> Mapping[str, tuple[str, ...]]:
    """Return the services with the nodes that offer or use them, an action by its own name."""
    found: dict[str, tuple[str, ...]] = {}
    for each in graph.endpoints(kind) if graph is not None else ():
        name = each.topic.removesuffix(ACTION)
        if is_shown(each.node.name) and not any(part.startswith("_") for part in name.split("/")):
            found[name] = tuple(dict.fromkeys((*found.get(name, ()), each.node.full_name)))
    return found
