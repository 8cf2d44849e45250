"""How far a whole class is: a row for each pupil, over all lessons and days, of the homes that `day6-tui serve` keeps.

`day6-tui report --data` and the page of the class make it with the same functions.
"""

from __future__ import annotations

import functools
import itertools
import os
from collections.abc import Sequence
from pathlib import Path
from typing import NamedTuple

from day6_core.classroom.homes import PupilHome, Strange, homes_of, opened_folder, read_file
from day6_core.lessons.catalogue import LessonOffer
from day6_core.lessons.progress import FOLDER, LARGEST, Progress, ProgressError, decode
from day6_core.lessons.report_lines import DRILLS, lines_of, moment
from day6_core.lessons.tables import Cell
from day6_core.lessons.texts import Say
from day6_core.reason import reason

MOST_FILES = 20
"""Progress files of one home; there is one, unless pupils share a home."""
MOST_ENTRIES = 1000
"""Of the folder in which they are."""


class Unread(NamedTuple):
    """A file that was left out, and why."""

    file: Path
    why: Say | str

    def text(self, language: str) -> str:
        return self.why.text(language) if isinstance(self.why, Say) else self.why


class PupilSoFar(NamedTuple):
    """A pupil of a class: how far, and what could not be read."""

    home: PupilHome
    progress: Progress
    unread: list[Unread]
    is_closed: bool = False
    """Whether the home is another user's, who lets nobody in."""


def class_of(data: Path) -> list[PupilSoFar]:
    """All pupils of the class that is kept in this folder, by name. Raises OSError."""
    return [so_far(home) for home in homes_of(data)]


def so_far(home: PupilHome) -> PupilSoFar:
    """How far a pupil is; a home with several progress files is one pupil's all the same."""
    found: list[Progress] = []
    unread: list[Unread] = []
    folder, is_closed = home.folder / FOLDER, False
    try:
        with opened_folder(home.folder, *FOLDER.parts) as number:
            with os.scandir(number) as entries:
                names = [each.name for each in itertools.islice(entries, MOST_ENTRIES) if each.name.endswith(".json")]
            for name in sorted(names)[:MOST_FILES]:
                try:
                    found.append(decode(read_file(number, name, LARGEST)))
                except Strange as error:
                    unread.append(Unread(folder / name, Say(f"report.unread.{error}")))
                except ProgressError as error:
                    unread.append(Unread(folder / name, str(error)))
                except OSError as error:
                    unread.append(Unread(folder / name, reason(error)))
    except FileNotFoundError:
        pass  # who has never come, or has not begun a lesson
    except OSError as error:
        is_closed = isinstance(error, PermissionError)
        unread.append(Unread(folder, reason(error)))
    progress = functools.reduce(Progress.joined, found, Progress())
    progress.pupil = home.name
    return PupilSoFar(home, progress, unread, is_closed)


class Table(NamedTuple):
    """A table as it is written: `short` is for a terminal of 80 columns."""

    heads: list[str]
    rows: list[list[object]]
    short_heads: list[str]
    short: list[list[object]]


def table_of(pupils: Sequence[PupilSoFar], offered: LessonOffer, language: str) -> Table:
    """A row for each pupil, a column for each lesson that anybody has begun, and what the pupil did in all of them."""
    lines = [lines_of([each.progress], offered.lessons, offered.drills) for each in pupils]
    begun = {line.lesson for each in lines for line in each if line.lesson}
    known = [lesson.name for lesson in offered.lessons if lesson.name in begun]
    known += [DRILLS] if DRILLS in begun else []
    others = begun.difference(known)
    titles = {lesson.name: lesson.title[language] for lesson in offered.lessons}
    titles[DRILLS] = Say("report.drills").text(language)
    steps = {line.lesson: line.steps for each in lines for line in each}
    sums = ("passed_over", "hints", "refused", "minutes", "last")
    rows: list[list[object]] = []
    for pupil, each in zip(pupils, lines, strict=True):
        by_name = {line.lesson: line for line in each}
        row: list[object] = [pupil.home.name]
        for name in known:
            line = by_name.get(name)
            whole = line is not None and line.solved == line.steps
            row.append("" if line is None else Cell(line.solved, "good") if whole else line.solved)
        if others:
            row.append(sum(line.solved for line in each if line.lesson in others) or "")
        row += [sum(line.passed_over for line in each), sum(line.hints for line in each)]
        row += [sum(line.refused for line in each), round(sum(line.seconds for line in each) / 60, 1)]
        row.append(moment(max(line.last for line in each)) or Say("report.never").text(language))
        rows.append([*row, " ".join(f"{bad.file.name}: {bad.text(language)}" for bad in pupil.unread)])
    last = [Say(f"report.{name}").text(language) for name in (*(("others",) if others else ()), *sums, "unread")]
    first = Say("report.pupil").text(language)
    heads = [first, *(Say("report.of_steps", name=titles[name], steps=steps[name]).text(language) for name in known)]
    short = [first, *(f"{titles[name] if name == DRILLS else name}/{steps[name]}" for name in known)]
    return Table([*heads, *last], rows, [*short, *last[:-1]], [row[:-1] for row in rows])
