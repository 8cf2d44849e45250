"""The line above the view that names RViz's tools, with their letters; the one in use is marked."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from typing import NamedTuple

from day6_core.ros.programs.rviz2.model.tools.tool import Tool
from day6_tui.panes.cells import cell_len

LOWEST_WINDOW = 12
"""Rows inside a window that has the line; a lower one needs them all for the view."""


class Name(NamedTuple):
    """A tool on the line: its column, its letter ('' for a tool without), its words."""

    column: int
    letter: str
    words: str
    tool: Tool

    @property
    def end(self) -> int:
        return self.column + cell_len(f"{self.letter} {self.words}".strip())


def names_in(tools: Sequence[Tool], current: Tool | None, width: int) -> list[Name]:
    """The tools on a line of `width` cells: whole names, short ones, or only letters but for the one in use."""
    forms = ([tool.title for tool in tools], [tool.short for tool in tools])
    for words in (*forms, [tool.short if tool is current else "" for tool in tools]):
        names = list(_placed(tools, words))
        if not names or names[-1].end <= width:
            return names
    return [name for name in names if name.end < width]


def _placed(tools: Sequence[Tool], words: Sequence[str]) -> Iterator[Name]:
    column = 1
    for tool, text in zip(tools, words, strict=True):
        name = Name(column, tool.key, text, tool)
        yield name
        column = name.end + 2
