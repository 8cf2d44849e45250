"""The lines below a window's picture: a program's remarks (an id and parameters) in the user's language."""

from __future__ import annotations

from collections.abc import Iterable
from typing import TYPE_CHECKING

from day6_tui.appearance.look import Look
from day6_tui.panes.cells import wrap

if TYPE_CHECKING:
    from day6_core.ros.programs.remark import Remark


def remark_lines(
    remarks: Iterable[Remark], look: Look, width: int, most: int, *, info_needs_room: bool = False
) -> list[tuple[str, str]]:
    """Return levels and lines of remarks. Remarks are never cut: the end of a sentence is often its point.

    Stops before the remark that would exceed `most` lines; the first is always included, unless its level is "info" and
    `info_needs_room` is set.
    """
    lines: list[tuple[str, str]] = []
    for remark in remarks:
        mark = "" if remark.level == "info" else f"{look.glyphs.warning} "
        words = wrap(look.texts(remark.id, **dict(remark.parameters)), width - 2 - len(mark))
        if len(lines) + len(words) > most and (lines or (info_needs_room and remark.level == "info")):
            break
        for text in words:
            lines.append((remark.level, f" {mark}{text}"))
            mark = " " * len(mark)
    return lines
