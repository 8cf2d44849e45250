"""What is wrong, in lines below a window's picture: remarks of a program (an id and parameters) in the user's language."""

from __future__ import annotations

from collections.abc import Iterable
from typing import Any

from day6_tui.tui.cells import wrap
from day6_tui.tui.look import Look


def remark_lines(
    remarks: Iterable[Any], look: Look, width: int, most: int, *, info_needs_room: bool = False
) -> list[tuple[str, str]]:
    """Levels and lines of remarks, the first ones whole: the end of a sentence is often its point.

    Ends before the remark with which there would be more than `most` lines; the first is there in any case, unless it is
    only worth knowing ("info") and `info_needs_room`.
    """
    said: list[tuple[str, str]] = []
    for remark in remarks:
        mark = "" if remark.level == "info" else f"{look.glyphs.warning} "
        words = wrap(look.texts(remark.id, **dict(remark.parameters)), width - 2 - len(mark))
        if len(said) + len(words) > most and (said or (info_needs_room and remark.level == "info")):
            break
        for text in words:
            said.append((remark.level, f" {mark}{text}"))
            mark = " " * len(mark)
    return said
