"""Cuts a lesson file into headings, fenced blocks and the text between them."""

from __future__ import annotations

import re
from typing import NamedTuple

_FENCE = re.compile(r"(~~~+|```+)\s*([\w+-]*)\s*\Z")
_TEXTS = re.compile(r"## +(zh|en)\b|### +(do|hints|answers|teacher)\s*\Z")


class Block(NamedTuple):
    """A run of lines: kind '' (text), '#', '##' or '###' (a heading), or the word after a fence."""

    kind: str
    line: int
    text: str
    open: bool = False
    """Whether the end of a fenced block is missing; `line` is that of its first line."""

    def closed_before(self) -> int:
        """The line before which the end is missing."""
        return self.line + self.text.rstrip("\n").count("\n") + 1


def blocks(lines: list[str], first: int) -> list[Block]:
    """The blocks of `lines`, of which the first has the number `first`.

    A fenced block without its end is taken to end where the next one, or a step's text, begins.
    """
    found: list[Block] = []
    text: list[str] = []
    begin = first
    fence = kind = ""

    def finish(kind: str, *, unclosed: bool = False) -> None:
        if kind or any(line.strip() for line in text):
            blank = 0 if kind else next(at for at, line in enumerate(text) if line.strip())
            whole = "".join(f"{line}\n" for line in text)
            found.append(Block(kind, begin + blank, whole if kind == "yaml" else whole.strip("\n"), unclosed))
        text.clear()

    for number, line in enumerate(lines, first):
        mark = _FENCE.match(line)
        if fence and ((mark is not None and mark[1][:3] == fence and mark[2]) or _TEXTS.match(line)):
            finish(kind or "text", unclosed=True)
            fence, begin = "", number
        if fence:
            if mark is not None and line.strip().startswith(fence) and not mark[2]:
                finish(kind or "text")
                fence, begin = "", number + 1
            else:
                text.append(line)
        elif mark is not None:
            finish("")
            fence, kind, begin = mark[1][:3], mark[2], number + 1
        elif line.startswith(("# ", "## ", "### ")):
            finish("")
            hashes, _, rest = line.partition(" ")
            found.append(Block(hashes, number, rest.strip()))
            begin = number + 1
        else:
            if not text:
                begin = number
            text.append(line)
    finish(kind or "text" if fence else "", unclosed=bool(fence))
    return found
