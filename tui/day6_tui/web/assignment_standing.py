"""How everybody stands with an assignment, while the server runs."""

from __future__ import annotations

import asyncio
from dataclasses import dataclass, field
from typing import Any

from day6_core.isolation.cell import IsolationError
from day6_core.lessons.work import TooLarge
from day6_core.reason import named_reason
from day6_core.session.harmless import one_line
from day6_tui.locale import Texts
from day6_tui.web.assignments import Assignment, Collected, Word
from day6_tui.web.grading_room import NotGraded
from day6_tui.web.pupil_files import BadPath

FAILURES = (OSError, IsolationError, TooLarge, BadPath, NotGraded)
"""Of one pupil's, after which the others' goes on."""


@dataclass
class Standing:
    """One assignment and how everybody stands; by `same_name` of the pupils."""

    assignment: Assignment
    collected: dict[str, Collected] = field(default_factory=dict)
    words: dict[str, Word] = field(default_factory=dict)
    changed: set[str] = field(default_factory=set)
    """Whose work is not as it was collected."""
    trouble: dict[str, str] = field(default_factory=dict)
    """Why something failed the last time."""
    owed: set[str] | None = None
    """From whom what was due could not be taken; None before that was tried."""
    again: float = 0.0
    """When that is tried next (seconds since 1970)."""
    working: str = ""
    """What is being done: collect, grade, return."""
    done: int = 0
    all: int = 0
    working_lock: asyncio.Lock = field(default_factory=asyncio.Lock)
    """Collecting, grading and giving back: one after the other."""
    writing: asyncio.Lock = field(default_factory=asyncio.Lock)


def title_of(assignment: Assignment, texts: Texts) -> str:
    """What it is called in the language of the texts."""
    return assignment.title.get(texts.language) or assignment.task.name


def why(error: Exception, texts: Texts) -> str:
    """The reason, for the teacher."""
    if isinstance(error, IsolationError):
        return texts(error.words.key, **error.words.values)
    if isinstance(error, TooLarge):
        return texts("assign.too_large")
    return one_line(named_reason(error))


def result_of(collected: Collected | None) -> dict[str, Any]:
    """What is shown of a grade."""
    grade = None if collected is None else collected.grade
    if grade is None:
        return {}
    return {
        name: grade[name] for name in ("points", "most", "unplayed", "shielded", "refused", "when") if name in grade
    }
