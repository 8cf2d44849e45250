"""How the fields of a message become lines of a list: the columns name, type and expression or value."""

from __future__ import annotations

from collections.abc import Iterable
from typing import TYPE_CHECKING

from day6_tui.tui.locale import Texts
from day6_tui.tui.windows.field_list import FieldLine

if TYPE_CHECKING:
    from day6_tui.core.ros.programs.rqt_py_common.message_form import FieldRow

VALUE = 2
"""The column of expressions and values."""


def columns_in(width: int) -> tuple[int, int, int]:
    """Widths of name, type and value: the value gets half of the window."""
    name = max(16, width * 3 // 10)
    kind = 0 if width < 40 else max(9, width // 4)
    return name, kind, max(1, width - name - kind - (2 if kind else 1))


def head_line(texts: Texts, part: str) -> FieldLine:
    """The names of the columns of a `part`: request, response, goal, …"""
    value = "fields.expression" if part in ("request", "goal") else "fields.value"
    return FieldLine("", (texts(f"fields.{part}"), texts("fields.type"), texts(value)), is_head=True)


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
        )
        for row in rows
    ]
