"""Saving and opening: DOT there and back, pictures that other programs can open, and errors that say what is wrong."""

from __future__ import annotations

import shutil
import subprocess
import xml.etree.ElementTree
from pathlib import Path

import pytest
from PIL import Image

from day6_core.ros.programs.rqt_graph.model.dot import DotError, read_dot, write_dot
from day6_core.ros.programs.rqt_graph.model.fit import unfitted
from day6_core.ros.programs.rqt_graph.model.image import WARNING, write_image
from day6_core.ros.programs.rqt_graph.model.shapes import Box, Edge
from tests.support.pdf_text import pdf_text

BOXES = [
    Box("/a/talker", ("/a/talker",), "node", "/a"),
    Box("/listener", ("/listener",), "node"),
    Box(" /a/b/chatter", ("/a/b/chatter",), "topic", "/a/b"),
    Box(" /tf", ("/tf",), "group"),
]
EDGES = [
    Edge("/a/talker", " /a/b/chatter", "", "/a/b/chatter"),
    Edge(" /a/b/chatter", "/listener", "", "/a/b/chatter"),
    Edge("/a/talker", " /tf", "", "/tf"),
]


def plain(boxes: list[Box]) -> set[tuple[str, str, str]]:
    return {(box.lines[0], box.shape, box.cluster) for box in boxes}


def test_a_saved_graph_reads_back_the_same() -> None:
    boxes, edges = read_dot(write_dot(BOXES, EDGES))
    names = {box.key: box.lines[0] for box in boxes}
    assert plain(boxes) == plain(BOXES)
    assert [(names[edge.start], names[edge.end]) for edge in edges] == [
        (edge.start.strip(), edge.end.strip()) for edge in EDGES
    ]


def test_an_edge_between_nodes_keeps_its_topic() -> None:
    edge = Edge("/a/talker", "/listener", "/chatter", "/chatter")
    _, (read,) = read_dot(write_dot(BOXES[:2], [edge]))
    assert read.label == "/chatter"


def test_what_a_person_writes_for_graphviz_is_shown() -> None:
    boxes, edges = read_dot('digraph { // by hand\n a -> b -> "c d" [label=x]; b [shape=box] }')
    assert [(box.lines[0], box.shape) for box in boxes] == [("a", "node"), ("b", "topic"), ("c d", "node")]
    assert [(edge.start, edge.end, edge.label) for edge in edges] == [("a", "b", "x"), ("b", "c d", "x")]


@pytest.mark.parametrize(
    ("text", "message"),
    [
        ("nodes 3", "a DOT file begins with 'digraph'"),
        ("digraph {\n a -> <b> }", "line 2: cannot read '<b> }'"),
        ("digraph { a -> b", "the file ends before its last '}'"),
        ("", "the file ends before its last '}'"),
    ],
)
def test_what_is_no_dot_says_where(text: str, message: str) -> None:
    with pytest.raises(DotError, match=message.replace("{", r"\{")):
        read_dot(text)


@pytest.mark.process
@pytest.mark.skipif(shutil.which("dot") is None, reason="Graphviz is not installed")
def test_graphviz_takes_the_file() -> None:
    done = subprocess.run(["dot", "-Tplain"], input=write_dot(BOXES, EDGES), capture_output=True, text=True)
    assert done.returncode == 0 and done.stdout.count("\nedge") == len(EDGES)


def test_the_svg_holds_every_name_and_shape(tmp_path: Path) -> None:
    write_image(unfitted(BOXES, EDGES), tmp_path / "graph.svg", {" /a/b/chatter": WARNING})
    root = xml.etree.ElementTree.parse(tmp_path / "graph.svg").getroot()
    texts = {element.text for element in root.iter("{http://www.w3.org/2000/svg}text")}
    assert texts >= {"/a/talker", "/listener", "/a/b/chatter", "/tf", "/a", "/a/b"}
    assert len(list(root.iter("{http://www.w3.org/2000/svg}ellipse"))) == 2
    assert len(list(root.iter("{http://www.w3.org/2000/svg}polygon"))) == len(EDGES)
    assert 'fill="#ff0000">/a/b/chatter' in (tmp_path / "graph.svg").read_text()


def test_a_picture_of_too_many_pixels_is_refused_and_a_drawing_is_not(tmp_path: Path) -> None:
    boxes = [Box(f"box {number}", ("x" * 200,), "node") for number in range(1000)]
    with pytest.raises(ValueError, match=r"graph.png': \d+ x \d+ pixels are too many; .svg and .pdf have no limit"):
        write_image(unfitted(boxes, []), tmp_path / "graph.png")
    write_image(unfitted(boxes, []), tmp_path / "graph.svg")
    assert [file.name for file in tmp_path.iterdir()] == ["graph.svg"]


def test_the_pdf_holds_every_name(tmp_path: Path) -> None:
    write_image(unfitted(BOXES, EDGES), tmp_path / "graph.pdf")
    text = pdf_text(tmp_path / "graph.pdf")
    assert all(name in text for name in ("/a/talker", "/listener", "/a/b/chatter", "/tf", "/a", "/a/b"))


@pytest.mark.parametrize("suffix", [".png", ".jpg", ".bmp"])
def test_the_picture_opens_and_is_not_empty(tmp_path: Path, suffix: str) -> None:
    picture = unfitted(BOXES, EDGES)
    write_image(picture, tmp_path / f"graph{suffix}")
    with Image.open(tmp_path / f"graph{suffix}") as image:
        assert image.width > image.height > 100
        assert sum(image.convert("L").histogram()[:64]) > 1000  # dark pixels


def test_an_unknown_suffix_names_those_that_work(tmp_path: Path) -> None:
    with pytest.raises(ValueError, match=r"'graph.gif': .dot, .svg, .pdf, .png"):
        write_image(unfitted(BOXES, EDGES), tmp_path / "graph.gif")


HOSTILE = 'a\x1b]0;T\x07<script>\x9b2J\u202e\uffff&\n"b'


@pytest.mark.parametrize("suffix", [".svg", ".png", ".pdf"])
def test_a_label_from_somebody_elses_file_is_text_in_the_picture(tmp_path: Path, suffix: str) -> None:
    boxes = [Box("a", (HOSTILE,), "node"), Box("b", (HOSTILE,), "topic", "/" + HOSTILE)]
    file = tmp_path / ("graph" + suffix)
    write_image(unfitted(boxes, [Edge("a", "b", HOSTILE, "b")]), file)
    if suffix == ".png":
        assert Image.open(file).size[0] > 0
        return
    if suffix == ".pdf":
        assert "a^[]0;T^G<script>\\x9b2J\\u202e\\uffff&^J" in pdf_text(file)
        return
    texts = [
        element.text or "" for element in xml.etree.ElementTree.parse(file).iter("{http://www.w3.org/2000/svg}text")
    ]
    assert [text for text in texts if text.startswith("a^[]0;T^G<script>\\x9b2J\\u202e\\uffff&^J")]
    assert all(text.isprintable() for text in texts)
