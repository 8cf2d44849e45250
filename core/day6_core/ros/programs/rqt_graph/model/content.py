"""What rqt_graph shows of a graph: nodes, topics and edges after its filters, and what was left out and why.

The rules are those of rqt_graph for ROS 2 (dotcode.py, rosgraph2_impl.py): topic filters work on the node-topic graph
first; the "Nodes only" view then keeps the node-node edges whose topic survived; "Debug" comes last.
"""

from __future__ import annotations

import re
from collections.abc import Mapping
from dataclasses import dataclass, field
from enum import Enum

from day6_core.ros.programs.rqt_graph.model.shapes import Box, Edge
from day6_core.user_pattern import user_pattern

QUIET_NAMES = (
    "/diag_agg",
    "/runtime_logger",
    "/pr2_dashboard",
    "/rviz",
    "/rosout",
    "/cpu_monitor",
    "/monitor",
    "/hd_monitor",
    "/rxloggerlevel",
    "/clock",
    "/rqt",
    "/statistics",
)
"""Names hidden by "Debug" wherever they occur inside a node or topic name."""

QUIET_EDGES = ("/time", "/clock", "/rosout", "/statistics")

ACTION_SUFFIXES = ("/status", "/result", "/goal", "/cancel", "/feedback")
"""The topics of an action in ROS 1's layout: rqt_graph groups only when all five are there, so not for ROS 2's two."""

ACTION_WEIGHT = 0.1
"""An action's feedback and status flow back to the client; they must not reverse the picture."""

IMAGE_SUFFIXES = ("/compressed", "/compressedDepth", "/theora", "")


class GraphType(Enum):
    """The entries of the combo box, with its labels."""

    NODES = "Nodes only"
    ACTIVE = "Nodes/Topics (active)"
    ALL = "Nodes/Topics (all)"


@dataclass(frozen=True)
class GraphOptions:
    """The state of rqt_graph's controls; the defaults are those of its window."""

    graph_type: GraphType = GraphType.NODES
    node_filter: str = "/"
    topic_filter: str = "/"
    namespaces: int = 2
    """Boxes around namespaces, nested up to this depth; 0 draws none."""
    group_actions: bool = True
    group_tf: bool = True
    group_images: bool = True
    hide_dead_sinks: bool = True
    hide_leaf_topics: bool = True
    hide_debug: bool = True
    hide_tf: bool = False
    hide_unreachable: bool = True
    """As in the real tool, where ROS 2 has no master that could call a node unreachable: it changes nothing."""
    hide_params: bool = True
    highlight: bool = True
    fit: bool = True


@dataclass(frozen=True)
class GraphContent:
    """What the graph consists of: full names of the nodes that publish and subscribe, by topic."""

    publishers: Mapping[str, tuple[str, ...]]
    subscribers: Mapping[str, tuple[str, ...]]
    incompatible: Mapping[str, tuple[str, ...]] = field(default_factory=dict)
    """Topics with QoS or type trouble, and the lines that explain it."""

    @property
    def nodes(self) -> list[str]:
        """Nodes with at least one endpoint, in order of appearance (rqt_graph knows no others)."""
        found: dict[str, None] = {}
        for table in (self.publishers, self.subscribers):
            for names in table.values():
                found.update(dict.fromkeys(names))
        return list(found)


@dataclass(frozen=True)
class Hidden:
    """Names left out by one option; `option` is the label of its check box."""

    option: str
    names: tuple[str, ...]


@dataclass(frozen=True)
class Content:
    """Boxes and edges to lay out, keys of the boxes or edges with trouble, and what is hidden."""

    boxes: tuple[Box, ...]
    edges: tuple[Edge, ...]
    hidden: tuple[Hidden, ...]
    trouble: Mapping[str, tuple[str, ...]]


Link = tuple[str, str]
"""Start and end of an edge of the node-topic graph; topics carry a leading space there, as in rqt_graph."""


def select(facts: GraphContent, options: GraphOptions) -> Content:
    """Apply the options to the facts."""
    topics = {" " + topic for topic in (*facts.publishers, *facts.subscribers)}
    links = {(node, " " + topic) for topic, names in facts.publishers.items() for node in names}
    links |= {(" " + topic, node) for topic, names in facts.subscribers.items() for node in names}
    hidden = _Hidden()

    nodes = hidden.drop("node filter", facts.nodes, lambda name: _passes(name, options.node_filter))
    topics = set(hidden.drop("topic filter", sorted(topics), lambda name: _passes(name, options.topic_filter)))

    leaving: dict[str, int] = {}
    touching: dict[str, int] = {}
    for start, end in links:
        leaving[start] = leaving.get(start, 0) + 1
        for name in (start, end):
            touching[name] = touching.get(name, 0) + 1
    if options.hide_dead_sinks:
        topics = set(hidden.drop("Dead sinks", sorted(topics), lambda name: leaving.get(name, 0) > 0))
    if options.hide_leaf_topics:
        topics = set(hidden.drop("Leaf topics", sorted(topics), lambda name: touching.get(name, 0) >= 2))
    if options.hide_tf:
        topics = set(hidden.drop("tf", sorted(topics), lambda name: name.strip() not in ("/tf", "/tf_static")))
    if options.hide_params:
        topics = set(hidden.drop("Params", sorted(topics), lambda name: not name.endswith("/parameter_events")))
    left = topics.union(nodes)
    links = {link for link in links if left.issuperset(link)}

    if options.graph_type is GraphType.NODES:
        return _node_view(facts, options, nodes, topics, hidden)
    return _topic_view(facts, options, nodes, topics, links, hidden)


def _node_view(
    facts: GraphContent, options: GraphOptions, nodes: list[str], topics: set[str], hidden: _Hidden
) -> Content:
    if options.hide_debug:
        nodes = hidden.drop("Debug", nodes, _is_loud)
    shown = set(nodes)
    edges = [
        Edge(start, end, topic, topic, ACTION_WEIGHT if "/_action/" in topic else 1.0)
        for topic, starts in facts.publishers.items()
        for start in dict.fromkeys(starts)
        for end in dict.fromkeys(facts.subscribers.get(topic, ()))
        if " " + topic in topics
        and start in shown
        and end in shown
        and not (options.hide_debug and topic in QUIET_EDGES)
    ]
    loops: dict[str, list[str]] = {}
    for edge in edges:
        if edge.start == edge.end:
            loops.setdefault(edge.start, []).append(edge.label)
    boxes = tuple(
        Box(
            name,
            (name, *(f"↺ {topic}" for topic in loops.get(name, ()))),
            "node",
            namespace_of(name, options.namespaces),
        )
        for name in nodes
    )
    drawn = {edge.key for edge in edges}
    trouble = {topic: lines for topic, lines in facts.incompatible.items() if topic in drawn}
    return Content(boxes, tuple(edges), hidden.found(), trouble)


def _topic_view(
    facts: GraphContent, options: GraphOptions, nodes: list[str], topics: set[str], links: set[Link], hidden: _Hidden
) -> Content:
    groups: dict[str, str] = {}
    if options.group_actions:
        groups.update(_groups(topics, "/feedback", ACTION_SUFFIXES, 5, "/action_topics"))
    if options.group_images:
        groups.update(_groups(topics, "/compressed", IMAGE_SUFFIXES, 3, "/image_topics"))
    if options.group_tf and not options.hide_tf:
        groups.update({name: " /tf" for name in topics if name in (" /tf", " /tf_static")})
    if options.hide_debug:
        nodes = hidden.drop("Debug", nodes, _is_loud)
        topics = set(hidden.drop("Debug", sorted(topics), _is_loud))
    shown = topics | set(nodes)
    links = {link for link in links if link[0] in shown and link[1] in shown}
    connected = {name for link in links for name in link}
    grouped = sorted({groups[topic] for topic in topics & connected & set(groups)})
    alone = sorted(topic for topic in topics & connected if topic not in groups)
    boxes = [
        Box(name, (name.strip(),), shape, namespace_of(name.strip(), options.namespaces))
        for shape, names in (("node", nodes), ("topic", alone), ("group", grouped))
        for name in names
    ]
    pairs = dict.fromkeys((groups.get(start, start), groups.get(end, end)) for start, end in sorted(links))
    edges = tuple(Edge(start, end, "", (start if start.startswith(" ") else end)[1:]) for start, end in pairs)
    trouble = {" " + topic: lines for topic, lines in facts.incompatible.items()}
    return Content(tuple(boxes), edges, hidden.found(), trouble)


def namespace_of(name: str, depth: int) -> str:
    """Return the namespace in whose box a name is drawn when boxes nest up to `depth`, '' if in none."""
    parts = name.split("/")
    return "/".join(parts[: min(depth + 1, len(parts) - 1)]) if depth > 0 and len(parts) > 2 else ""


def _groups(topics: set[str], mark: str, suffixes: tuple[str, ...], least: int, group: str) -> dict[str, str]:
    """Map each topic of a complete family (an action's five, an image's transports) to its group box."""
    found: dict[str, str] = {}
    for name in topics:
        if name.endswith(mark):
            prefix = name[: -len(mark)]
            family = [prefix + suffix for suffix in suffixes if prefix + suffix in topics]
            if len(family) >= least:
                found.update(dict.fromkeys(family, prefix + group))
    return found


def _is_loud(name: str) -> bool:
    """Whether "Debug" leaves a name visible."""
    return not any(quiet in name for quiet in QUIET_NAMES) and not name.rsplit("/", 1)[-1].startswith("_")


def _passes(name: str, text: str) -> bool:
    """Apply a filter field: comma-separated names or regular expressions, `-` in front excludes."""
    parts = [part.strip() for part in text.split(",")]
    excludes = [part[1:] for part in parts if part.startswith("-")]
    includes = [part for part in parts if not part.startswith("-")]
    if includes in ([], ["/"], [""]):
        includes = [".*"]
    return _matches_any(name, includes) and not _matches_any(name, excludes)


def _matches_any(name: str, patterns: list[str]) -> bool:
    name = name.strip()
    for pattern in patterns:
        if name == pattern:
            return True
        if not re.fullmatch(r"[a-zA-Z0-9_/]+", pattern):
            try:
                if user_pattern(pattern).match(name):
                    return True
            except re.error:
                continue
    return False


class _Hidden:
    """Collects what each option left out."""

    def __init__(self) -> None:
        self._names: dict[str, list[str]] = {}

    def drop(self, option: str, names: list[str], keep: object) -> list[str]:
        """Return the names for which `keep` holds and remember the others."""
        assert callable(keep)
        kept = [name for name in names if keep(name)]
        left = set(kept)
        gone = [name.strip() for name in names if name not in left]
        if gone:
            self._names.setdefault(option, []).extend(gone)
        return kept

    def found(self) -> tuple[Hidden, ...]:
        return tuple(Hidden(option, tuple(dict.fromkeys(names))) for option, names in self._names.items())
