"""Full names of nodes as a tree of namespaces, in lines; which branches are folded is given."""

from __future__ import annotations

from collections.abc import Collection, Iterable
from typing import NamedTuple


class NodeLine(NamedTuple):
    """One line of the tree: the end of `path`, below its namespace."""

    path: str
    """The full name of a node or a namespace; both, if there is a node `/a` and a node `/a/b`."""
    depth: int
    is_node: bool
    has_children: bool

    @property
    def text(self) -> str:
        return self.path.rpartition("/")[2]


def node_lines(nodes: Iterable[str], folded: Collection[str]) -> list[NodeLine]:
    """The lines of the tree, sorted by name; of a folded branch only its own one."""
    nodes = set(nodes)
    parents = {path for node in nodes for path in _parents(node)}
    paths = sorted(nodes | parents, key=lambda path: path.split("/"))
    return [
        NodeLine(path, path.count("/") - 1, path in nodes, path in parents)
        for path in paths
        if not any(parent in folded for parent in _parents(path))
    ]


def _parents(path: str) -> list[str]:
    parts = path.split("/")
    return ["/".join(parts[:end]) for end in range(2, len(parts))]
