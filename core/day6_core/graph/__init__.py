"""The graph of nodes and endpoints inside one process: names, QoS matching, delivery, graph events.

Imports nothing else of day6-tui; everything else may import it. rclpy (`ros/python`) is built on it; `day6_core.link` joins
the graphs of several processes.
"""

from day6_core.graph.endpoints import (
    Client,
    Endpoint,
    EndpointKind,
    MessageInfo,
    Publisher,
    RequestId,
    Service,
    Subscription,
)
from day6_core.graph.graph import Graph, GraphEvent, graph_for_domain
from day6_core.graph.node import Node
from day6_core.graph.qos import QoS

__all__ = [
    "Client",
    "Endpoint",
    "EndpointKind",
    "Graph",
    "GraphEvent",
    "MessageInfo",
    "Node",
    "Publisher",
    "QoS",
    "RequestId",
    "Service",
    "Subscription",
    "graph_for_domain",
]
