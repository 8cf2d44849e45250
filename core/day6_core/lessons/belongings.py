"""Which files of a home belong to which of our lessons: those that checks and solutions name, and those that grading plays.

Paths are below the home folder. A lesson of a teacher's own folder is not known here.
"""

from __future__ import annotations

import re
from collections.abc import Collection, Iterable, Iterator
from fnmatch import fnmatchcase
from functools import cache
from pathlib import PurePosixPath
from typing import Any

from day6_core.lessons.checks import Condition
from day6_core.lessons.document import Lesson

_FILE = re.compile(r"~/([\w*./-]*\.\w+)")
_OF_PACKAGES = ("package.xml", "setup.py", "setup.cfg", "CMakeLists.txt")
"""Files that come with a package: lessons change them one after the other."""
_SOURCE = ("ros2_ws", "src")


@cache
def _patterns() -> dict[str, frozenset[str]]:
    """lesson or drill -> its files; the days in their order, then the drills."""
    from day6_core.lessons.catalogue import days, drills
    from day6_core.lessons.grading.scenarios import gradings

    played = {each.lesson: each.scenarios for each in gradings()}
    found = {}
    for lesson in (*days(), *drills()):
        names = set(_named_in(lesson))
        for scenario in played.get(lesson.name, ()):
            names.update(_files(scenario.files))
        found[lesson.name] = frozenset(names)
    return found


def _named_in(lesson: Lesson) -> Iterator[str]:
    for step in lesson.steps:
        yield from _files(step.checks)
        yield from _files(step.solve)


def _files(found: Any) -> Iterator[str]:
    """Every text below this that is the path of a file and nothing else."""
    if isinstance(found, str):
        match = _FILE.fullmatch(found)
        if match is not None and PurePosixPath(match[1]).name not in _OF_PACKAGES:
            yield match[1]
    elif isinstance(found, Condition):
        yield from _files((*found.arguments.values(), *found.parts))
    elif isinstance(found, dict):
        yield from _files(list(found.values()))
    elif isinstance(found, (list, tuple)):
        for each in found:
            yield from _files(each)


def is_known(lesson: str) -> bool:
    """Whether it is one of ours."""
    return lesson in _patterns()


def owners(path: str) -> list[str]:
    """The lessons and drills that a file belongs to, the earliest first."""
    return [name for name, patterns in _patterns().items() if _matches(path, patterns)]


def belonging(lessons: Collection[str], paths: Iterable[str]) -> set[str]:
    """Those of these files that may be of one of these lessons: its own, and beside them what is of no lesson."""
    of = {path: owners(path) for path in paths}
    own = {path for path, names in of.items() if not set(lessons).isdisjoint(names)}
    places = {_place(path) for path in own}
    return own | {path for path, names in of.items() if not names and _place(path) in places}


def folders(lessons: Iterable[str]) -> set[str]:
    """The folders that lessons have for themselves, directly in the home."""
    tops = {PurePosixPath(each).parts[0] for name in lessons for each in _patterns().get(name, ()) if "/" in each}
    return tops - {_SOURCE[0]}


def _place(path: str) -> PurePosixPath:
    """The package that a file is in, or its folder."""
    parts = PurePosixPath(path).parts
    if parts[:2] == _SOURCE and len(parts) > 3:
        return PurePosixPath(*parts[:3])
    return PurePosixPath(path).parent


def _matches(path: str, patterns: Iterable[str]) -> bool:
    depth = path.count("/")
    return any(depth == each.count("/") and fnmatchcase(path, each) for each in patterns)
