"""Marks in a sentence, `code` and **strong**: taken out of the text, and drawn as styles."""

from __future__ import annotations

import re
from itertools import groupby

from rich.segment import Segment
from rich.style import Style

from day6_core.session.harmless import one_line
from day6_tui.panes.cells import wrap

Line = list[Segment]

_CODE = re.compile(r"`([^`]+)`()")
_CODE_OR_STRONG = re.compile(r"`([^`]+)`|\*\*([^*]+)\*\*")


def marked_lines(text: str, width: int, plain: Style, code: Style, strong: Style | None = None) -> list[Line]:
    """Break a text into lines of at most `width` cells, its marks drawn in their styles.

    Without `strong` two asterisks are what a name may contain, and no mark.
    """
    letters = ""
    styles: list[Style] = []
    at = 0
    for match in (_CODE if strong is None else _CODE_OR_STRONG).finditer(text):
        before, marked = one_line(text[at : match.start()]), one_line(match[1] or match[2])
        letters += before + marked
        styles += [plain] * len(before) + [code if match[1] else strong or plain] * len(marked)
        at = match.end()
    rest = one_line(text[at:])
    letters += rest
    styles += [plain] * len(rest)
    found: list[Line] = []
    at = 0
    for line in wrap(letters, width):
        at = max(at, letters.find(line, at)) if line else at
        cells = list(zip(line, styles[at : at + len(line)], strict=False))
        found.append(
            [
                Segment("".join(char for char, _ in run), style)
                for style, run in groupby(cells, key=lambda cell: cell[1])
            ]
        )
        at += len(line)
    return found
