"""Which lessons and drills there are: those that come with the program, and those of a folder."""

from __future__ import annotations

import re
from collections.abc import Iterable
from dataclasses import dataclass
from functools import cache
from itertools import islice
from pathlib import Path

from day6_core.lessons.document import Lesson
from day6_core.lessons.reading import read_lesson
from day6_core.lessons.remarks import TOPICS
from day6_core.lessons.source import LessonMistakes

HERE = Path(__file__).parent
MOST_FILES = 500

_NAMED = re.compile(r"(?:lesson|drill): *([\w-]+)")


@dataclass
class Found:
    """The lessons of a folder in their order, and what is wrong with the others."""

    lessons: tuple[Lesson, ...]
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
    return Found(tuple(sorted(lessons, key=lambda each: (each.is_drill, each.order, each.name))), mistakes)


def shipped_names() -> set[str]:
    """The names of all lessons and drills that come with the program."""
    found = set()
    for path in (*(HERE / "days").glob("*.md"), *(HERE / "drills").glob("*.md")):
        with open(path, encoding="utf-8") as file:
            found |= {match[1] for line in islice(file, 20) if (match := _NAMED.match(line)) is not None}
    return found


@cache
def days() -> tuple[Lesson, ...]:
    """The six days, read once in a process."""
    return lessons_in(HERE / "days").lessons


@cache
def drills() -> tuple[Lesson, ...]:
    """The drills, by topic and the number of their fault, read once in a process."""
    return tuple(by_topic(lessons_in(HERE / "drills").lessons))


def is_shipped(lesson: Lesson) -> bool:
    """Whether it comes with the program; a teacher's own does not."""
    return HERE in lesson.path.parents


def by_topic(lessons: Iterable[Lesson]) -> list[Lesson]:
    """Drills in the order of their topics."""
    known = {topic: at for at, topic in enumerate(TOPICS)}
    return sorted(lessons, key=lambda each: (known.get(each.topic, len(TOPICS)), each.topic, each.order, each.name))
