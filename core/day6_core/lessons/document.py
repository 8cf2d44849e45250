"""What a lesson is: steps with their checks and actions, and the texts in both languages (`writing/en.md`)."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

from day6_core.lessons.checks import Condition
from day6_core.lessons.source import Mistake

HINTS = 3

Action = Mapping[str, Any]
"""One action: a dictionary with one key."""


@dataclass(frozen=True)
class Answer:
    """A choice of a question."""

    letter: str
    text: str
    reason: str = ""


@dataclass(frozen=True)
class Page:
    """A step's texts in one language; `body` and `do` are Markdown as writing/en.md describes it."""

    title: str
    picture: tuple[str, ...] = ()
    body: str = ""
    do: str = ""
    hints: tuple[str, ...] = ()
    answers: tuple[Answer, ...] = ()
    teacher: str = ""


@dataclass(frozen=True)
class Wrong:
    """A tempting wrong answer: what is done, part of the message that refuses it, how to clear it away."""

    do: tuple[Action, ...]
    says: str
    undo: tuple[Action, ...] = ()
    line: int = 0


@dataclass(frozen=True)
class Step:
    """One step of a lesson."""

    name: str
    line: int
    checks: tuple[Condition, ...] = ()
    solve: tuple[Action, ...] = ()
    wrong: tuple[Wrong, ...] = ()
    needs: tuple[str, ...] = ()
    before: tuple[Action, ...] = ()
    command: str = ""
    see: tuple[str, ...] = ("terminal",)
    """What has to be on the screen beside the lesson: terminals, and windows by kind. The first one gets the keyboard."""
    pages: Mapping[str, Page] = field(default_factory=dict)
    lines: Mapping[str, int] = field(default_factory=dict)
    """The lines of the keys of the yaml block."""
    broken: bool = False
    """Whether the block is no YAML, so that nothing is known of it (only while a file is read)."""


@dataclass(frozen=True)
class Lesson:
    """A whole file: a lesson or, with `fault`, a drill."""

    name: str
    path: Path
    order: int
    minutes: int
    title: Mapping[str, str]
    steps: tuple[Step, ...]
    is_drill: bool = False
    fault: int = 0
    topic: str = ""
    line: int = 1
    """That of the name."""
    remarks: tuple[Mistake, ...] = ()
    """What `lessons check` tells of a file that can be used."""

    def step(self, name: str) -> Step | None:
        return next((step for step in self.steps if step.name == name), None)
