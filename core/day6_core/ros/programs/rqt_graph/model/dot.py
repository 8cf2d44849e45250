"""The graph as a DOT file, as rqt_graph saves it for Graphviz, and back.

Names are those of the real tool: nodes `n_<name>`, topics `t_<name>`, left to right, namespaces as clusters.
"""

from __future__ import annotations

import re
from collections.abc import Iterator, Sequence
from itertools import pairwise

from day6_core.ros.programs.rqt_graph.model.shapes import Box, Edge

_SHAPES = {"node": "ellipse", "topic": "box", "group": "box3d"}
_BACK = {shape: ours for ours, shape in _SHAPES.items()}

_TOKEN = re.compile(
    r"""\s+|//[^\n]*|\#[^\n]*|/\*.*?\*/"""
    r"""|(?P<quoted>"(?:[^"\\]|\\.)*")"""
    r"""|(?P<sign>->|--|[{}\[\];,=])"""
    r"""|(?P<word>[A-Za-z_\u0080-\uffff][\w\u0080-\uffff]*(?::[a-z]+)?|-?(?:\.\d+|\d+(?:\.\d*)?))""",
    re.DOTALL,
)


class DotError(ValueError):
    """The text isn't a DOT graph; the message says where."""


# -- writing -----------------------------------------------------------------------------------------------------------


def write_dot(boxes: Sequence[Box], edges: Sequence[Edge]) -> str:
    """Return the DOT text of a graph."""
    lines = ["digraph graphname {", 'graph [bb="", compound=True, rank=same, rankdir=LR, ranksep=0.2];']
    lines += _cluster("", boxes, "")
    names = {box.key: _identifier(box) for box in boxes}
    for edge in edges:
        label = f" [URL={_quoted(f'topic:{edge.label}')}, label={_quoted(edge.label)}]" if edge.label else ""
        lines.append(f"{names[edge.start]} -> {names[edge.end]}{label};")
    return "\n".join([*lines, "}", ""])


def _cluster(name: str, boxes: Sequence[Box], indent: str) -> list[str]:
    """Return the boxes of a cluster, and in it the clusters below it."""
    lines = [f"{indent}{_node(box)}" for box in boxes if box.cluster == name]
    inner = {box.cluster for box in boxes if box.cluster.startswith(name + "/") and box.cluster != name}
    children = sorted({name + "/" + rest[len(name) + 1 :].split("/")[0] for rest in inner})
    for child in children:
        lines.append(f"{indent}subgraph {_quoted('cluster_' + child)} {{")
        lines.append(f"{indent}  label={_quoted(child)};")
        lines += _cluster(child, boxes, indent + "  ")
        lines.append(f"{indent}}}")
    return lines


def _node(box: Box) -> str:
    label = box.lines[0]
    url = label if box.shape == "node" else f"topic:{label}"
    return f"{_identifier(box)} [URL={_quoted(url)}, label={_quoted(label)}, shape={_SHAPES[box.shape]}];"


def _identifier(box: Box) -> str:
    return _quoted(("n_" if box.shape == "node" else "t_") + box.lines[0])


def _quoted(text: str) -> str:
    return '"' + text.replace("\\", "\\\\").replace('"', '\\"') + '"'


# -- reading -----------------------------------------------------------------------------------------------------------


def read_dot(text: str) -> tuple[list[Box], list[Edge]]:
    """Return the boxes and edges of a DOT text, as rqt_graph, pydot or a person writes it. Raises DotError."""
    reader = _Reader(text)
    reader.graph()
    return list(reader.boxes.values()), reader.edges


class _Reader:
    """Reads `digraph`, `subgraph`, node and edge statements with attributes; ports and HTML labels are not known."""

    def __init__(self, text: str) -> None:
        self._tokens = list(_tokens(text))
        self._at = 0
        self.boxes: dict[str, Box] = {}
        self.edges: list[Edge] = []

    def graph(self) -> None:
        if self._peek() == "strict":
            self._next()
        if self._next() not in ("digraph", "graph"):
            raise DotError("a DOT file begins with 'digraph'")
        if self._peek() != "{":
            self._next()
        self._statements("")

    def _statements(self, cluster: str) -> None:
        self._expect("{")
        while self._peek() != "}":
            self._statement(cluster)
        self._next()

    def _statement(self, cluster: str) -> None:
        word = self._next()
        if word in (";", ","):
            return
        if word == "subgraph":
            name = self._next() if self._peek() != "{" else ""
            self._statements(name[len("cluster_") :] if name.startswith("cluster_") else cluster)
        elif word == "{":
            self._at -= 1
            self._statements(cluster)
        elif word in ("graph", "node", "edge") and self._peek() == "[":
            self._attributes()
        elif self._peek() == "=":
            self._next()
            self._next()
        else:
            self._nodes_and_edges(word, cluster)

    def _nodes_and_edges(self, first: str, cluster: str) -> None:
        names = [first]
        while self._peek() in ("->", "--"):
            self._next()
            names.append(self._next())
        attributes = self._attributes()
        for name in names:
            known = self.boxes.get(name)
            if known is None or len(names) == 1:
                label = attributes.get("label", name) if len(names) == 1 else name
                shape = _BACK.get(attributes.get("shape", "ellipse"), "node") if len(names) == 1 else "node"
                self.boxes[name] = Box(name, (label,), shape, known.cluster if known else cluster)
        label = attributes.get("label", "")
        self.edges += [Edge(start, end, label, label or end) for start, end in pairwise(names)]

    def _attributes(self) -> dict[str, str]:
        found: dict[str, str] = {}
        while self._peek() == "[":
            self._next()
            while self._peek() != "]":
                name = self._next()
                if name in (",", ";"):
                    continue
                value = "true"
                if self._peek() == "=":
                    self._next()
                    value = self._next()
                found[name] = value
            self._next()
        return found

    def _peek(self) -> str:
        if self._at >= len(self._tokens):
            raise DotError("the file ends before its last '}'")
        return self._tokens[self._at]

    def _next(self) -> str:
        token = self._peek()
        self._at += 1
        return token

    def _expect(self, token: str) -> None:
        found = self._next()
        if found != token:
            raise DotError(f"expected '{token}', found '{found}'")


def _tokens(text: str) -> Iterator[str]:
    at = 0
    while at < len(text):
        match = _TOKEN.match(text, at)
        if match is None:
            line = text.count("\n", 0, at) + 1
            raise DotError(f"line {line}: cannot read '{text[at : at + 20]}'")
        at = match.end()
        if match["quoted"]:
            yield re.sub(r"\\(.)", r"\1", match["quoted"][1:-1])
        elif match["sign"] or match["word"]:
            yield match["sign"] or match["word"]
