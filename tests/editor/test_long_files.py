"""A long file: its colours are those that the whole of it has, though only of lines that are seen any are asked for."""

from __future__ import annotations

import random
from pathlib import Path
from typing import Any

import pytest
from textual._tree_sitter import get_language
from textual.widgets import TextArea

from day6_tui.textual_private.document import document_of
from day6_tui.textual_private.text_area import BLOCK, Highlights
from tests.editor.editor_bench import Bench

LINES = (
    "import rclpy  # 机器人",
    "class Talker(Node):",
    '    """Says hello, and goes on',
    "    for ever",
    '    to say so."""',
    "    def __init__(self, *names: str) -> None:",
    "        self.text = f'{names[0]} {1 + 2}' if names else None",
    "    @property",
    "    async def say(self): return [print(each, end='') for each in self.names]",
    "",
)


@pytest.fixture
def text() -> str:
    chance = random.Random(4)
    return "\n".join(chance.choice(LINES) for _ in range(6 * BLOCK))


def test_each_line_has_the_colours_that_it_has_in_the_whole_file(text: str) -> None:
    area = TextArea.code_editor(text, language="python")
    document: Any = document_of(text, get_language("python"))
    query = document.prepare_query(area._get_builtin_highlight_query("python"))
    found = Highlights(document, query)
    assert area._highlights
    for line in range(text.count("\n") + 1):
        assert sorted(found[line], key=str) == sorted(area._highlights[line], key=str), line


def test_a_key_asks_for_the_colours_of_lines_that_are_seen_only(
    tmp_path: Path, text: str, monkeypatch: pytest.MonkeyPatch
) -> None:
    asked: list[int] = []
    original = Highlights.__missing__

    def counted(self: Highlights, line: int) -> Any:
        asked.append(line)
        return original(self, line)

    monkeypatch.setattr(Highlights, "__missing__", counted)

    async def act(bench: Bench) -> None:
        await bench.press("x")
        assert 1 <= len(asked) <= 12 and max(asked) < BLOCK
        bench.pane.area.move_cursor((6 * BLOCK - 1, 0))
        await bench.press("x")
        assert max(asked) >= 5 * BLOCK
        assert not {line // BLOCK for line in asked} & {1, 2, 3}

    bench = Bench(tmp_path)
    bench.path.write_text(text, encoding="utf-8")
    bench.run(act)
