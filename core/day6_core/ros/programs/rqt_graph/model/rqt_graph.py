"""What the rqt_graph window draws: the graph as a node sees it, seen through the options."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path
from typing import TYPE_CHECKING

from day6_core.graph import EndpointKind, Graph, Publisher
from day6_core.graph.names import full_name
from day6_core.ros.programs.rqt_graph.model.content import Content, GraphContent, GraphOptions, select
from day6_core.ros.programs.rqt_graph.model.dot import read_dot, write_dot
from day6_core.ros.programs.rqt_graph.model.fit import unfitted
from day6_core.ros.programs.rqt_graph.model.image import WARNING, write_image
from day6_core.whole_file import replace_file

if TYPE_CHECKING:
    from rclpy.node import Node
    from rclpy.topic_endpoint_info import TopicEndpointInfo


class RqtGraph:
    """The model of one rqt_graph window.

    `content` is replaced as a whole and `version` raised by every refresh that changed something; windows on other
    threads read both. `options` and `auto_refresh` are set by the window through `change_options`.
    """

    def __init__(self, node: Node, graph: Graph, path: Callable[[str], Path]) -> None:
        self._node = node
        self._graph = graph
        self.path = path
        """The file that a user of this program means."""
        self._facts = GraphContent({}, {})
        self.loaded = ""
        """Name of the DOT file that is shown instead of the live graph, '' normally."""
        self.options = GraphOptions()
        self.auto_refresh = True
        self.version = 0
        self.content: Content = select(self._facts, self.options)
        self.on_request: Callable[[], None] | None = None
        """Called (any thread) when the window wants a refresh."""

    def refresh(self) -> None:
        """Look at the graph again (on the program's thread)."""
        facts = read_facts(self._node)
        if self.loaded:
            self._facts = facts
        else:
            self._show(facts, self.options)

    def change_options(self, options: GraphOptions) -> None:
        """Use other options from now on. What only concerns looking also holds for a graph from a file."""
        if self.loaded:
            self.options = options
        else:
            self._show(self._facts, options)

    def request_refresh(self) -> None:
        """The button "Refresh ROS graph": the live graph again."""
        if self.loaded:
            self.loaded = ""
            self._show(self._facts, self.options)
        if self.on_request is not None:
            self.on_request()

    def activity(self) -> dict[str, int]:
        """Return by topic how many messages have passed through this process so far."""
        found: dict[str, int] = {}
        for endpoint in self._graph.endpoints(EndpointKind.PUBLISHER):
            if isinstance(endpoint, Publisher):
                found[endpoint.topic] = found.get(endpoint.topic, 0) + endpoint.delivered
        return found

    def save(self, name: str) -> Path:
        """Write what is shown to a file, a relative name where the program was started; the suffix says what kind.

        `.dot` is the graph for Graphviz, `.svg`, `.pdf`, `.png` and others are the picture. Raises OSError and ValueError.
        """
        path = self.path(name)
        if path.suffix.lower() == ".dot":
            replace_file(path, write_dot(self.content.boxes, self.content.edges).encode("utf-8"))
        else:
            write_image(
                unfitted(self.content.boxes, self.content.edges), path, dict.fromkeys(self.content.trouble, WARNING)
            )
        return path

    def load(self, name: str) -> None:
        """Show the graph of a DOT file until the next refresh. Raises OSError and ValueError."""
        path = self.path(name)
        boxes, edges = read_dot(path.read_text(encoding="utf-8"))
        self.loaded = path.name
        self.content = Content(tuple(boxes), tuple(edges), (), {})
        self.version += 1

    def _show(self, facts: GraphContent, options: GraphOptions) -> None:
        content = select(facts, options)
        self._facts, self.options = facts, options
        if content != self.content:
            self.content = content
            self.version += 1


def read_facts(node: Node) -> GraphContent:
    """Ask a node for the publishers and subscribers of all topics, as rqt_graph does."""
    publishers: dict[str, list[str]] = {}
    subscribers: dict[str, list[str]] = {}
    for name, namespace in node.get_node_names_and_namespaces():
        full = full_name(namespace, name)
        for topic, _ in node.get_publisher_names_and_types_by_node(name, namespace):
            publishers.setdefault(topic, []).append(full)
        for topic, _ in node.get_subscriber_names_and_types_by_node(name, namespace):
            subscribers.setdefault(topic, []).append(full)
    both = [topic for topic in publishers if topic in subscribers]
    trouble = {topic: lines for topic in both if (lines := _incompatibilities(node, topic))}
    return GraphContent(
        {topic: tuple(names) for topic, names in sorted(publishers.items())},
        {topic: tuple(names) for topic, names in sorted(subscribers.items())},
        trouble,
    )


def _incompatibilities(node: Node, topic: str) -> tuple[str, ...]:
    """Return the lines of rqt_graph's tooltip for a topic whose endpoints cannot hear each other."""
    from rclpy.qos import QoSCompatibility, qos_check_compatible

    offers, requests = node.get_publishers_info_by_topic(topic), node.get_subscriptions_info_by_topic(topic)

    def deaf(offer: TopicEndpointInfo, request: TopicEndpointInfo) -> bool:
        return qos_check_compatible(offer.qos_profile, request.qos_profile)[0] == QoSCompatibility.ERROR

    def other_type(offer: TopicEndpointInfo, request: TopicEndpointInfo) -> bool:
        return bool(offer.topic_type != request.topic_type)

    for kind, fits_not, advice in (
        ("type", other_type, f"Use `ros2 topic info -v {topic}` to check types"),
        ("qos", deaf, f"Use `ros2 topic info -v {topic}` to check the qos profiles"),
    ):
        found: dict[str, list[str]] = {}
        for offer in offers:
            for request in requests:
                if fits_not(offer, request):
                    found.setdefault(_name(offer), []).append(_name(request))
        if found:
            lines = [
                f"- Publisher of node `{publisher}` incompatible with subscriptions of nodes `{', '.join(names)}`"
                for publisher, names in found.items()
            ]
            return (f"Found {kind} incompatibilities:", *lines, advice)
    return ()


def _name(info: TopicEndpointInfo) -> str:
    return full_name(info.node_namespace, info.node_name)
