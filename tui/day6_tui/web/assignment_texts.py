"""What pupils and a school's system get to read: marks as a text, and the table of an assignment as CSV."""

from __future__ import annotations

import time
from collections.abc import Iterable, Mapping
from typing import Any

from day6_core.lessons.tables import csv_bytes
from day6_core.session.harmless import one_line
from day6_tui.locale import Texts
from day6_tui.web.assignments import Assignment, Collected, Word

COLUMNS = (
    "name", "state", "collected", "late", "changed", "solved", "steps", "points", "most", "unplayed", "mark", "remark",
    "returned",
)  # fmt: skip


def clock(when: float) -> str:
    """The time of today, else with its date; "" for never."""
    if not when:
        return ""
    local = time.localtime(when)
    is_today = local[:3] == time.localtime()[:3]
    return time.strftime("%H:%M" if is_today else "%Y-%m-%d %H:%M", local)


def due_text(texts: Texts, due: float) -> str:
    """Until when, to be put behind something; "" for whenever."""
    return texts("assign.due", when=clock(due)) if due else ""


def as_csv(rows: Iterable[Mapping[str, Any]], texts: Texts) -> bytes:
    """A row for each pupil, UTF-8 with a mark, no cell a formula."""
    head = [texts(f"assign.column.{column}") for column in COLUMNS]
    return csv_bytes(head, [[_cell(column, row.get(column, ""), texts) for column in COLUMNS] for row in rows])


def _cell(column: str, value: Any, texts: Texts) -> object:
    if column == "state":
        return texts(f"assign.state.{value}")
    if column in ("collected", "returned"):
        return time.strftime("%Y-%m-%d %H:%M:%S", time.localtime(value)) if value else ""
    if isinstance(value, bool):
        return int(value)
    return "" if value is None else value


def marks_text(texts: Texts, assignment: Assignment, collected: Collected | None, word: Word) -> bytes:
    """What is given back to a pupil, in the language of the texts."""
    language = texts.language
    title = one_line(assignment.title.get(language) or assignment.task.name)
    parts = [f"# {texts('assign.marks.title', title=title)}"]
    if word.mark:
        parts.append(texts("assign.marks.mark", mark=one_line(word.mark)))
    if word.line:
        parts.append(texts("assign.marks.line", line=one_line(word.line)))
    if collected is not None:
        key = "assign.marks.late" if collected.late else "assign.marks.collected"
        parts.append(texts(key, when=time.strftime("%Y-%m-%d %H:%M", time.localtime(collected.when))))
        parts += _graded(texts, collected.grade)
    return ("\n\n".join(parts) + "\n").encode(errors="replace")


def _graded(texts: Texts, grade: Mapping[str, Any] | None) -> list[str]:
    if grade is None:
        return []
    language = texts.language
    if grade["refused"] is not None:
        return [texts("assign.marks.refused", reason=grade["refused"][language])]
    found = [texts("assign.marks.points", points=f"{grade['points']:g}", most=f"{grade['most']:g}")]
    for each in grade["scenarios"]:
        mark = texts(f"assign.mark.{each['mark']}")
        lines = [f"- {each['title'][language]}: {mark}, {each['points']:g}/{each['most']:g}"]
        for check in (check for check in each["checks"] if not check["ok"]):
            lines.append(texts("assign.marks.check", asked=check["asked"][language], seen=check["seen"][language]))
        found.append("\n".join(lines))
    return found
