"""The tree of frames as it is told by a service, and drawn: any names, any shape."""

from __future__ import annotations

import random
from pathlib import Path

import pytest
from tf2_ros import Buffer

from day6_core.ros.programs._drawn_pdf import laid_out
from day6_core.ros.programs.rqt_graph.model.image import write_image
from day6_core.ros.programs.rqt_graph.model.pdf import LONGEST
from day6_core.ros.programs.tf2_tools.frame_tree import Frame, as_dot, as_graph, read_frames, roots
from tests.support.folded import folded
from tests.support.pdf_text import pdf_size, pdf_text
from tests.tf2.conftest import stamped


def frame(name: str, parent: str) -> Frame:
    return Frame(name, parent, "default_authority", 10.213, 4.7, 104.7, 100.0)


def drawn(frames: list[Frame], file: Path) -> str:
    write_image(laid_out(*as_graph(frames, 12.5)), file)
    return pdf_text(file)


@folded(
    "name",
    ["car", "底盘", "轮子_左", "it's", 'a "quoted" one', "back\\slash", "a: b", "- x", "# y", "1", "true", "null", "x" * 3000,
     "a\nb", "\x1b[31m", "{", "'", "[]", "*a", "&a", "!x", "%y", "@z", "`", "? k", "1.5", "2026-01-01", "a #b", "~", "é"],
)  # fmt: skip
def test_the_service_tells_every_name(name: str) -> None:
    buffer = Buffer()
    buffer.set_transform(stamped("world", name, 5), "the 'authority'")
    buffer.set_transform(stamped(name, "below", 5), name)
    below, above = sorted(read_frames(buffer.all_frames_as_yaml()), key=lambda each: each.name != "below")
    assert (below.parent, below.broadcaster) == (name, name)
    assert (above.name, above.parent, above.broadcaster) == (name, "world", "the 'authority'")


def test_plain_names_are_written_as_by_the_original() -> None:
    buffer = Buffer()
    buffer.set_transform(stamped("world", "turtle1/base-link.2", 5), "default_authority")
    assert buffer.all_frames_as_yaml().startswith(
        "turtle1/base-link.2: \n  parent: 'world'\n  broadcaster: 'default_authority'\n  rate: 10000.000\n"
    )


NUMBERS = "rate: 1, buffer_length: 1, most_recent_transform: 1, oldest_transform: 1"


@pytest.mark.parametrize(
    "text",
    [
        "a: {",
        "a: 1",
        "- a",
        "a: {parent: b}",
        "just words",
        "? [a]\n: b",
        f"a: {{parent: b, broadcaster: c, {NUMBERS.replace('1', 'fast')}}}",
        f"a: {{parent: [b], broadcaster: c, {NUMBERS}}}",
        "[" * 5000,
    ],
)
def test_an_answer_that_is_no_tree_of_frames_is_refused(text: str) -> None:
    with pytest.raises(ValueError):
        read_frames(text)


def test_no_frames_are_an_empty_list_as_the_original_writes_it() -> None:
    assert read_frames("[]") == read_frames("") == ()


def test_every_edge_says_who_sends_it_how_often_and_from_when(tmp_path: Path) -> None:
    text = drawn([frame("car", "world")], tmp_path / "a.pdf")
    for line in ("world", "car", "Broadcaster:default_authority", "Averagerate:10.213", "Bufferlength:4.7",
                 "Mostrecenttransform:104.7", "Oldesttransform:100.0", "view_framesResult", "Recordedattime:12.5"):  # fmt: skip
        assert line in text


def test_without_frames_the_drawing_says_so(tmp_path: Path) -> None:
    assert drawn([], tmp_path / "a.pdf") == "Notfdatareceived"


def test_names_of_any_script_are_written(tmp_path: Path) -> None:
    text = drawn([frame("轮子_左", "世界"), frame("바퀴", "世界"), frame("ñandú€", "世界")], tmp_path / "a.pdf")
    assert all(name in text for name in ("世界", "轮子_左", "바퀴", "ñandú€"))


def test_what_no_font_has_and_what_is_no_sign_is_written_as_an_escape(tmp_path: Path) -> None:
    text = drawn([frame("नी", "a\x1b]0;T\x07\nb"), frame('q"\\', "a\x1b]0;T\x07\nb")], tmp_path / "a.pdf")
    assert all(name in text for name in ("\\u0928\\u0940", "a^[]0;T^G^Jb", 'q"\\'))


def test_a_circle_and_several_roots_are_drawn(tmp_path: Path) -> None:
    frames = [frame("a", "b"), frame("b", "c"), frame("c", "a"), frame("me", "me"), frame("x", "y"), frame("z", "w")]
    assert roots(frames) == ("y", "w")
    picture = laid_out(*as_graph(frames, 1.0))
    assert {box.lines[0] for box, _ in picture.boxes.values() if box.shape == "node"} == set("abcxyzw") | {"me"}
    assert len(picture.routes) == 2 * len(frames)
    assert "view_frames" not in as_dot(frames[:3], 1.0)  # graphviz' legend hangs on the root, and there is none
    assert "view_framesResult" in drawn(frames[:3], tmp_path / "a.pdf")


def test_the_legend_of_graphviz_hangs_on_the_root_that_is_named_last() -> None:
    frames = [frame("a", "x"), frame("b", "y"), frame("c", "x")]
    assert as_dot(frames, 1.0).endswith('"Recorded at time: 1.0"[ shape=plaintext ] ;\n}->"x";\n}')


@pytest.mark.long
@pytest.mark.parametrize("shape", ["chain", "star", "random"])
def test_three_hundred_frames_are_one_page_that_every_viewer_opens(tmp_path: Path, shape: str) -> None:
    parents = {"chain": lambda number: number - 1, "star": lambda _: 0, "random": random.Random(1).randrange}[shape]
    frames = [frame(f"f{number}.", f"f{parents(number)}.") for number in range(1, 301)]
    text = drawn(frames, tmp_path / "a.pdf")
    assert all(each.name in text for each in frames)
    assert max(pdf_size(tmp_path / "a.pdf")) <= LONGEST


def test_no_box_lies_on_another() -> None:
    dice = random.Random(2)
    frames = [frame(f"f{number}", f"f{dice.randrange(number)}") for number in range(1, 80)]
    picture = laid_out(*as_graph(frames, 1.0))
    cells = [
        (x, y)
        for _, rect in picture.boxes.values()
        for x in range(rect.x, rect.x + rect.width)
        for y in range(rect.y, rect.y + rect.height)
    ]
    assert len(cells) == len(set(cells))
    covered = set(cells)
    assert not [cell for route in picture.routes for cell in route.cells if cell in covered]


def test_the_edges_to_the_children_of_a_frame_branch_off_one_trunk() -> None:
    picture = laid_out(*as_graph([frame(f"f{number}", "root") for number in range(9)], 1.0))
    cells = [route.cells for route in picture.routes if route.edge.start == "frame root"]
    upright = [{x for x, y in each if (x, y + 1) in each} for each in cells]
    assert len(cells) == 9 and len(set.union(*upright)) == 1
