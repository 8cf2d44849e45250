"""Which lessons and drills there are: those that come with the program, and those of a folder."""

from __future__ import annotations

import re
from collections.abc import Iterable
from dataclasses import dataclass, replace
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


@dataclass(frozen=True)
class LessonOffer:
    """Lessons and drills in their order, and what is wrong with the files that cannot be used."""

    lessons: tuple[Lesson, ...]
    drills: tuple[Lesson, ...] = ()
    broken: tuple[LessonMistakes, ...] = ()

    @property
    def all(self) -> tuple[Lesson, ...]:
        return (*self.lessons, *self.drills)

    def named(self, name: str) -> Lesson | None:
        return next((each for each in self.all if each.name == name), None)

    def with_file_of(self, new: Lesson) -> LessonOffer:
        """With a lesson as its file is now."""
        lessons, drills = (
            [new if each.path == new.path else each for each in some] for some in (self.lessons, self.drills)
        )
        return LessonOffer(tuple(lessons), tuple(drills), self.broken)


def lessons_in(folder: Path) -> LessonOffer:
    """Read all lessons (`*.md`) of a folder."""
    lessons, broken = [], []
    for path in sorted(folder.glob("*.md"))[:MOST_FILES]:
        if path.name.lower() == "readme.md":
            continue
        try:
            lessons.append(read_lesson(path))
        except LessonMistakes as error:
            broken.append(error)
    lessons.sort(key=lambda each: (each.order, each.name))
    drills = tuple(each for each in lessons if each.is_drill)
    return LessonOffer(tuple(each for each in lessons if not each.is_drill), drills, tuple(broken))


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
    return tuple(by_topic(lessons_in(HERE / "drills").drills))


def offer(folder: Path | None = None) -> LessonOffer:
    """The lessons and drills of a teacher's folder, else the six days; and the drills that come with the program."""
    own = lessons_in(folder) if folder is not None else LessonOffer(days())
    return replace(own, drills=(*by_topic(own.drills), *drills()))


def is_shipped(lesson: Lesson) -> bool:
    """Whether it comes with the program; a teacher's own does not."""
    return HERE in lesson.path.parents


def by_topic(lessons: Iterable[Lesson]) -> list[Lesson]:
    """Drills in the order of their topics."""
    known = {topic: at for at, topic in enumerate(TOPICS)}
    return sorted(lessons, key=lambda each: (known.get(each.topic, len(TOPICS)), each.topic, each.order, each.name))
