"""The little Markdown of lessons as lines of cells: paragraphs, `code`, **strong**, lists, blocks of code."""

from __future__ import annotations

import re
from collections.abc import Iterator

from rich.segment import Segment
from rich.style import Style

from day6_core.session.harmless import one_line
from day6_tui.appearance.colours import Colours
from day6_tui.panes.cells import cell_len
from day6_tui.panes.marks import marked_lines

Line = list[Segment]

_ITEM = re.compile(r"(\s*)(-|\d+\.)\s+(.*)\Z")


def text_lines(
    markdown: str, width: int, colours: Colours, style: Style | None = None, *, goes_on: str = "| "
) -> list[Line]:
    """Markdown in lines of at most `width` cells. `goes_on` stands before the rest of a line of code that is too long."""
    plain = colours.text if style is None else style
    found: list[Line] = []
    block = ""
    for paragraph in _paragraphs(markdown):
        if paragraph.startswith("```"):
            block = paragraph.split("\n", 1)[1].removesuffix("```").rstrip("\n")
            found += [[Segment(" ", plain), *line] for line in _code(block, width - 1, colours, goes_on)]
            continue
        if not paragraph:
            found.append([])
            continue
        item = _ITEM.match(paragraph)
        if item is not None:
            mark = "· " if item[2] == "-" else f"{item[2]} "
            lines = marked_lines(item[3], width - cell_len(mark), plain, colours.publisher, colours.strong)
            found += [
                [Segment(mark if not at else " " * cell_len(mark), plain), *line] for at, line in enumerate(lines)
            ]
        else:
            found += marked_lines(paragraph, width, plain, colours.publisher, colours.strong)
    return found


def _paragraphs(markdown: str) -> Iterator[str]:
    """Paragraphs, each list item and block of code on its own, '' for the empty lines between."""
    text: list[str] = []
    code: list[str] | None = None
    for line in markdown.split("\n"):
        if code is not None:
            code.append(line)
            if line.strip().startswith(("```", "~~~")):
                yield "\n".join(["```", *code[:-1]])
                code = None
        elif line.strip().startswith(("```", "~~~")):
            if text:
                yield _joined(text)
                text = []
            code = []
        elif not line.strip() or _ITEM.match(line):
            if text:
                yield _joined(text)
            text = [line] if line.strip() else []
            if not line.strip():
                yield ""
        else:
            text.append(line)
    if code is not None:
        yield "\n".join(["```", *code])
    elif text:
        yield _joined(text)


def _joined(lines: list[str]) -> str:
    """The lines of a paragraph as one: with a blank between them where words meet, without one between Chinese characters."""
    whole = lines[0]
    for line in lines[1:]:
        line = line.strip()
        wide = whole and line and cell_len(whole[-1]) == 2 and cell_len(line[0]) == 2
        whole += line if wide else f" {line}"
    return whole


def _code(block: str, width: int, colours: Colours, goes_on: str) -> Iterator[Line]:
    """Lines of code as they are; one that is too long goes on below, where it can be seen that it does."""
    for line in block.split("\n"):
        rest, before = one_line(line.replace("\t", "    ")), ""
        while rest or not before:
            head = _broken(rest, width - len(before))
            yield [Segment(before, colours.muted), Segment(head, colours.publisher)]
            rest, before = rest[len(head) :], goes_on


def _broken(text: str, width: int) -> str:
    """What fits of a line of code: up to a blank or a sign, not the half of a word."""
    head = _head(text, width)
    if len(head) == len(text):
        return head
    indent = len(text) - len(text.lstrip())
    for signs in (" ", ",([{=/"):
        ends = [at for at, char in enumerate(head, 1) if char in signs and at > max(indent, len(head) // 2)]
        if ends:
            return head[: ends[-1]]
    return head


def _head(text: str, width: int) -> str:
    used = 0
    for at, char in enumerate(text):
        used += cell_len(char)
        if used > max(2, width):
            return text[:at]
    return text
