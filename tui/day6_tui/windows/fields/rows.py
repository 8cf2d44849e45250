"""How the fields of a message become lines of a list: the columns name, type and expression or value."""

from __future__ import annotations

from collections.abc import Iterable
from typing import TYPE_CHECKING

from day6_tui.locale import Texts
from day6_tui.windows.fields.field_list import FieldLine, FieldNeeds

if TYPE_CHECKING:
    from day6_core.ros.programs.rqt_py_common.message_form import FieldRow

VALUE = 2
"""The column of expressions and values."""


FEW = 8
"""Elements of an array that are shown at once."""


NARROW = 60
"""Cells below which names and types get no more room than they need."""

LEAST_VALUE = 10
"""Cells that values have to keep beside a column of types."""


def columns_in(width: int, needs: FieldNeeds) -> tuple[int, int, int]:
    """Widths of name, type and value: the value gets half of a wide window, and in a narrow one what is left."""
    if width >= NARROW:
        name, kind = max(16, width * 3 // 10), max(9, width // 4)
    else:
        name, kind = narrow_columns(width, needs)
    return name, kind, max(1, width - name - kind - (2 if kind else 1))


def narrow_columns(width: int, needs: FieldNeeds) -> tuple[int, int]:
    """Widths of name and type in a narrow window; 0 for the type where there is no room for it."""
    name = min(max(8, needs.name), width * 9 // 20)
    kind = min(needs.type, width * 3 // 10)
    return (name, kind) if width - name - kind - 2 >= LEAST_VALUE else (min(max(8, needs.name), width // 2), 0)


def head_line(texts: Texts, part: str) -> FieldLine:
    """The names of the columns of a `part`: request, response, goal, …"""
    value = "fields.expression" if part in ("request", "goal") else "fields.value"
    return FieldLine("", (texts(f"fields.{part}"), texts("fields.type"), texts(value)), is_head=True)


def is_long(row: FieldRow) -> bool:
    """Whether it is an array whose elements would push everything else out of sight: its branch begins closed."""
    return row.elements > FEW


def problem_of(row: FieldRow, texts: Texts) -> str:
    """What is wrong with the expression of a line, and what counts in its place."""
    return f"{row.problem}  {texts('fields.in_force', text=row.in_force)}" if row.in_force else row.problem


def lines_of(rows: Iterable[FieldRow], prefix: str, *, editable: bool = False) -> list[FieldLine]:
    """Lines for the rows of a tree; `prefix` stands before their paths in the keys of the lines."""
    return [
        FieldLine(
            prefix + row.path,
            (row.name, row.type, row.text),
            row.depth,
            VALUE if editable and row.path else None,
            row.text,
            is_branch=row.is_branch,
            problem=row.problem,
            begins_closed=is_long(row),
        )
        for row in rows
    ]
