"""A program typed from a book comes out as it is printed, with its blanks or without; what is pasted is never moved."""

from __future__ import annotations

from pathlib import Path

import pytest

from tests.editor.editor_bench import Bench

BOOK = """\
class Talker(Node):
    def __init__(self):
        super().__init__('t')
        self.x = [
            1,
        ]

    def tick(self):
        if self.x:
            return
        self.x = 0

def main():
    rclpy.init()
"""
LISTING = "def a():\n    return 1\n\ndef b():\n    return 2\n"


@pytest.fixture
def bench(tmp_path: Path) -> Bench:
    pytest.importorskip("tree_sitter_python")
    return Bench(tmp_path)


def test_typed_with_the_blanks_of_the_book(bench: Bench) -> None:
    texts = []

    async def act(bench: Bench) -> None:
        await bench.type(BOOK)
        texts.append(bench.text)

    bench.run(act)
    assert texts == [BOOK]


def test_typed_without_blanks_the_lines_go_as_deep_as_they_must(bench: Bench) -> None:
    texts = []

    async def act(bench: Bench) -> None:
        await bench.type("class A:\ndef f(self):\nx = [\n1,\n]\nreturn x")
        texts.append(bench.text)

    bench.run(act)
    assert texts == ["class A:\n    def f(self):\n        x = [\n            1,\n        ]\n        return x"]


def test_blanks_in_a_line_and_before_its_rest_are_just_typed(bench: Bench) -> None:
    texts = []

    async def act(bench: Bench) -> None:
        await bench.type("if a:\nb  = 1; c")
        bench.pane.area.move_cursor((1, 12))
        await bench.type("\n  ")
        texts.append(bench.text)

    bench.run(act)
    assert texts == ["if a:\n    b  = 1; \n      c"]


@pytest.mark.parametrize(
    ("typed", "pasted", "text"),
    [
        ("class A:\n", "    def f(self):\n        return 1\n", "class A:\n    def f(self):\n        return 1\n"),
        ("class A:\n", "def f(self):\n        return 1\n", "class A:\n    def f(self):\n        return 1\n"),
        ("class A:\n", "x = 1\n    y = 2", "class A:\n    x = 1\n    y = 2"),
        ("class A:\n", "x = 1", "class A:\n    x = 1"),
        ("if x:\ny\n", LISTING, "if x:\n    y\n" + LISTING),
        ("x = ", "  1\n  2", "x =   1\n  2"),
    ],
)
def test_what_is_pasted_keeps_its_own_blanks(bench: Bench, typed: str, pasted: str, text: str) -> None:
    texts = []

    async def act(bench: Bench) -> None:
        await bench.type(typed)
        await bench.paste(pasted)
        texts.append(bench.text)

    bench.run(act)
    assert texts == [text]
