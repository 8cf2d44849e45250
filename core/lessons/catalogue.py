"""Which lessons and drills there are: those that come with the program, and those of a folder."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass
from pathlib import Path

from day6_tui.core.lessons.document import Lesson, LessonMistakes, read_lesson

HERE = Path(__file__).parent
MOST_FILES = 500

TOPICS = (
    "environment", "workspace", "package", "code", "names", "types", "qos", "parameters", "services", "tf", "rviz", "time",
    "network",
)  # fmt: skip
"""The topics of drills, in the order in which they are listed; others come last."""


@dataclass
class Found:
    """The lessons of a folder in their order, and what is wrong with the others."""

    lessons: list[Lesson]
    mistakes: list[LessonMistakes]


def lessons_in(folder: Path) -> Found:
    """Read all lessons (`*.md`) of a folder."""
    lessons, mistakes = [], []
    for path in sorted(folder.glob("*.md"))[:MOST_FILES]:
        if path.name.lower() == "readme.md":
            continue
        try:
            lessons.append(read_lesson(path))
        except LessonMistakes as error:
            mistakes.append(error)
    return Found(sorted(lessons, key=lambda each: (each.is_drill, each.order, each.name)), mistakes)


def days() -> list[Lesson]:
    """The six days."""
    return lessons_in(HERE / "days").lessons


def drills() -> list[Lesson]:
    """The drills, by topic and the number of their fault."""
    return by_topic(lessons_in(HERE / "drills").lessons)


def by_topic(lessons: Iterable[Lesson]) -> list[Lesson]:
    """Drills in the order of their topics."""
    known = {topic: at for at, topic in enumerate(TOPICS)}
    return sorted(lessons, key=lambda each: (known.get(each.topic, len(TOPICS)), each.topic, each.order, each.name))
