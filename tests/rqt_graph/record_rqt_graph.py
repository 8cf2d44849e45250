"""Records what the real rqt_graph shows of one graph with every combination of its controls; by hand:

    python -m tests.rqt_graph.record_rqt_graph --sources FOLDER [--clone]

FOLDER has a checkout of ros-visualization/rqt_graph (see tests/conformance/checkouts.py; `--clone` fetches it). Two of its
modules are run, without Qt: the one that asks a node for the graph, and the one that chooses nodes and edges. What they draw goes
to recorded.json.gz: the distinct pictures, and for each combination, in the order of `combinations`, the number of its picture.
"""

from __future__ import annotations

import argparse
import gzip
import importlib
import json
import sys
import tempfile
import types
from collections.abc import Iterator, Mapping
from itertools import product
from pathlib import Path
from typing import Any

REPOSITORY, COMMIT = "ros-visualization/rqt_graph", "7b45f8a6e86e0d7d03a25d6a585ab4394f7d228e"
DATA = Path(__file__).with_name("recorded.json.gz")
MODES = ("node_node", "node_topic", "node_topic_all")
GROUPS = ("group_actions", "group_tf", "group_images")
HIDES = ("hide_dead_sinks", "hide_leaf_topics", "hide_debug", "hide_tf", "hide_params")
THEIR_NAMES = {
    "group_actions": "accumulate_actions",
    "group_tf": "group_tf_nodes",
    "group_images": "group_image_nodes",
    "hide_dead_sinks": "hide_dead_end_topics",
    "hide_leaf_topics": "hide_single_connection_topics",
    "hide_debug": "quiet",
    "hide_tf": "hide_tf_nodes",
    "hide_params": "hide_dynamic_reconfigure",
}

Picture = tuple[list[str], list[list[str]]]
"""Sorted names of boxes; sorted edges, each with start, end, label."""


def combinations() -> Iterator[tuple[str, dict[str, bool]]]:
    """Yield every type of graph with every position of the switches."""
    for mode in MODES:
        for positions in product((True, False), repeat=len(GROUPS) + len(HIDES)):
            yield mode, dict(zip((*GROUPS, *HIDES), positions, strict=True))


def load() -> tuple[list[Picture], list[int]]:
    """Return what was recorded: the distinct pictures, and the number of each combination's."""
    recorded = json.loads(gzip.decompress(DATA.read_bytes()))
    return recorded["pictures"], recorded["combinations"]


class _Node:
    """Answers what the real tool asks a node about the graph."""

    def __init__(self, publishers: Mapping[str, tuple[str, ...]], subscribers: Mapping[str, tuple[str, ...]]) -> None:
        self.tables = publishers, subscribers

    def get_node_names_and_namespaces(self) -> list[tuple[str, str]]:
        names = {node for table in self.tables for nodes in table.values() for node in nodes}
        return [(name.rpartition("/")[2], name.rpartition("/")[0] or "/") for name in sorted(names)]

    def _topics(self, table: Mapping[str, tuple[str, ...]], name: str, namespace: str) -> list[tuple[str, list[str]]]:
        full = f"{namespace.rstrip('/')}/{name}"
        return [(topic, []) for topic, nodes in table.items() if full in nodes]

    def get_publisher_names_and_types_by_node(self, name: str, namespace: str) -> list[tuple[str, list[str]]]:
        return self._topics(self.tables[0], name, namespace)

    def get_subscriber_names_and_types_by_node(self, name: str, namespace: str) -> list[tuple[str, list[str]]]:
        return self._topics(self.tables[1], name, namespace)

    def get_service_names_and_types_by_node(self, name: str, namespace: str) -> list[tuple[str, list[str]]]:
        return []

    def _endpoints(self, nodes: tuple[str, ...]) -> list[Any]:
        from rclpy.qos import QoSProfile

        names = [node.rpartition("/") for node in nodes]
        return [
            types.SimpleNamespace(node_name=name, node_namespace=place or "/", qos_profile=QoSProfile(depth=10))
            for place, _, name in names
        ]

    def get_publishers_info_by_topic(self, topic: str) -> list[Any]:
        return self._endpoints(self.tables[0].get(topic, ()))

    def get_subscriptions_info_by_topic(self, topic: str) -> list[Any]:
        return self._endpoints(self.tables[1].get(topic, ()))


class _Drawing:
    """Takes what the real tool would draw."""

    def __init__(self) -> None:
        self.boxes: set[str] = set()
        self.edges: set[tuple[str, str, str]] = set()

    def get_graph(self, **_: Any) -> _Drawing:
        return self

    def add_subgraph_to_graph(self, *_: Any, **__: Any) -> _Drawing:
        return self

    def add_node_to_graph(self, *_: Any, nodelabel: str, **__: Any) -> None:
        self.boxes.add(nodelabel)

    def add_edge_to_graph(self, _: Any, start: str, end: str, label: str = "", **__: Any) -> None:
        # `n_` and `t_` tell nodes from topics; a group of topics is called after its letter once more.
        names = (name[2:].removeprefix("n") for name in (start, end))
        self.edges.add((*names, label))

    def picture(self) -> Picture:
        return sorted(self.boxes), sorted(map(list, self.edges))


def record(tree: Path) -> None:
    """Run the real modules of a checkout and write the data."""
    from tests.rqt_graph.one_graph import FACTS

    binding = types.ModuleType("python_qt_binding.QtCore")
    binding.qDebug = binding.qWarning = lambda *_: None  # type: ignore[attr-defined]
    sys.modules.update({"python_qt_binding": types.ModuleType("python_qt_binding"), binding.__name__: binding})
    sys.path.insert(0, str(tree / "src"))
    impl, dotcode = (importlib.import_module(f"rqt_graph.{name}") for name in ("rosgraph2_impl", "dotcode"))
    node = _Node(FACTS.publishers, FACTS.subscribers)
    graph = impl.Graph(node)
    graph._graph_refresh()
    numbers: dict[str, int] = {}
    shown: list[int] = []
    for mode, switches in combinations():
        drawing = _Drawing()
        their = {THEIR_NAMES[name]: on for name, on in switches.items()}
        dotcode.RosGraphDotcodeGenerator(node).generate_dotgraph(graph, "/", "/", mode, drawing, **their)
        shown.append(numbers.setdefault(json.dumps(drawing.picture()), len(numbers)))
    text = json.dumps({"pictures": [json.loads(each) for each in numbers], "combinations": shown})
    DATA.write_bytes(gzip.compress(text.encode(), mtime=0))
    print(f"{len(shown)} combinations, {len(numbers)} pictures")


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--sources", type=Path, required=True, help="folder with a checkout of rqt_graph")
    parser.add_argument("--clone", action="store_true", help="clone it there if it is missing")
    chosen = parser.parse_args()
    from day6_core.ros import environment
    from tests.conformance.checkouts import extract

    environment.activate()
    with tempfile.TemporaryDirectory() as folder:
        record(extract(REPOSITORY, COMMIT, chosen.sources, Path(folder), clone=chosen.clone))


if __name__ == "__main__":
    main()
