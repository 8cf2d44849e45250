"""The tree of frames as plain data: order, roots, circles, what is old; and what is saved of it."""

from __future__ import annotations

from pathlib import Path

import pytest
from PIL import Image

from day6_core.ros.programs.rqt_tf_tree.model import TfTree, snapshot
from day6_core.ros.programs.tf2_tools.frame_tree import Frame
from tests.support.pdf_text import pdf_text


def frame(name: str, parent: str, *, newest: float = 100.0, rate: float = 10.0) -> Frame:
    return Frame(name, parent, "default_authority", rate, 4.7, newest, newest - 4.7)


def drawn(*frames: Frame) -> list[str]:
    """The lines, indented."""
    found = snapshot(frames, 100.0).lines
    return [f"{'  ' * len(line.ends)}{line.name}{' again' if line.again else ''}" for line in found]


def test_every_frame_stands_below_its_parent_sorted_by_name() -> None:
    frames = (frame("wheel", "car"), frame("car", "world"), frame("antenna", "car"), frame("tree", "world"))
    assert drawn(*frames) == ["world", "  car", "    antenna", "    wheel", "  tree"]


def test_roots_that_are_not_connected_stand_one_below_the_other() -> None:
    assert drawn(frame("b", "y"), frame("a", "x")) == ["x", "  a", "y", "  b"]


def test_a_circle_ends_where_its_first_frame_comes_again() -> None:
    frames = (frame("a", "c"), frame("b", "a"), frame("c", "b"), frame("hand", "b"))
    assert drawn(*frames) == ["a", "  b", "    c", "      a again", "    hand"]
    assert drawn(frame("me", "me")) == ["me", "  me again"]


def test_which_branches_end_is_known_for_every_level() -> None:
    lines = snapshot([frame("a", "r"), frame("b", "r"), frame("c", "a")], 100.0).lines
    assert {line.name: line.ends for line in lines} == {"r": (), "a": (False,), "c": (False, True), "b": (True,)}


def test_only_a_root_has_no_frame() -> None:
    assert [line.name for line in snapshot([frame("b", "a"), frame("x", "x")], 1.0).lines if line.frame is None] == [
        "a"
    ]


def test_a_chain_longer_than_pythons_stack_is_a_tree_too() -> None:
    lines = snapshot([frame(f"f{number + 1}", f"f{number}") for number in range(5000)], 1.0).lines
    assert len(lines) == 5001 and len(lines[-1].ends) == 5000


@pytest.mark.parametrize(
    ("newest", "rate", "age", "old"),
    [
        (99.5, 10.0, 0.5, False),
        (98.5, 10.0, 1.5, True),
        (98.5, 1.0, 1.5, False),  # at 1 Hz that is no more than a late one
        (96.5, 1.0, 3.5, True),
        (0.0, 10_000.0, None, False),  # static
        (101.0, 10.0, -1.0, False),
    ],
)
def test_a_frame_is_old_when_it_was_due_long_ago(newest: float, rate: float, age: float | None, old: bool) -> None:
    shot = snapshot([frame("a", "r", newest=newest, rate=rate)], 100.0)
    assert shot.age(shot.frames[0]) == age
    assert shot.is_old(shot.frames[0]) is old


@pytest.fixture
def tree(tmp_path: Path) -> TfTree:
    model = TfTree(tmp_path.joinpath)
    model.show(snapshot([frame("轮子", "car"), frame("car", "world")], 12.5))
    return model


def test_the_tree_is_saved_as_what_the_suffix_says(tree: TfTree, tmp_path: Path) -> None:
    for suffix in ("dot", "svg", "pdf", "png"):
        tree.save(f"frames.{suffix}")
        assert tree.saved == (f"frames.{suffix}", "")
    assert '"car" -> "轮子"[label=" Broadcaster: default_authority' in (tmp_path / "frames.dot").read_text("utf-8")
    assert "Buffer length: 4.7" in (tmp_path / "frames.svg").read_text("utf-8")
    assert "轮子" in pdf_text(tmp_path / "frames.pdf")
    with Image.open(tmp_path / "frames.png") as image:
        assert image.width > image.height > 100


def test_an_unknown_suffix_is_refused_before_anything_is_written(tree: TfTree) -> None:
    with pytest.raises(ValueError, match=r"'frames.gif'"):
        tree.request_save("frames.gif")
    assert tree.save_wanted == ""


def test_what_cannot_be_written_is_told_and_what_was_there_stays(tree: TfTree, tmp_path: Path) -> None:
    (tmp_path / "frames.pdf").mkdir()
    tree.save("frames.pdf")
    assert tree.saved == ("frames.pdf", "Is a directory")
    tree.save("nowhere/frames.pdf")
    assert tree.saved == ("frames.pdf", "No such file or directory")
    assert [file.name for file in tmp_path.iterdir()] == ["frames.pdf"]
