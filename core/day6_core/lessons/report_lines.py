"""How far pupils are: a line for each lesson that each of them has begun."""

from __future__ import annotations

import time
from collections.abc import Sequence
from dataclasses import dataclass

from day6_core.language import LANGUAGES
from day6_core.lessons.document import Lesson
from day6_core.lessons.progress import Progress, StepDone
from day6_core.lessons.tables import Cell
from day6_core.lessons.texts import Say

DRILLS = "drills"
COLUMNS = ("pupil", "lesson", "solved", "passed_over", "hints", "refused", "minutes", "last")


@dataclass(frozen=True)
class ReportLine:
    """One pupil and one lesson (or all drills together). `last`: when a step was solved last, 0: never; `seconds`: in all."""

    pupil: str
    lesson: str
    title: dict[str, str]
    solved: int
    steps: int
    passed_over: int
    hints: int
    refused: int
    seconds: float
    last: float


def lines_of(pupils: list[Progress], lessons: Sequence[Lesson], faults: Sequence[Lesson]) -> list[ReportLine]:
    """A line for every lesson that a pupil has begun, and one for the drills."""
    found: list[ReportLine] = []
    drill_names = {drill.name for drill in faults}
    known_names = {DRILLS, *drill_names, *(lesson.name for lesson in lessons)}
    for progress in pupils:
        before = len(found)
        for lesson in lessons:
            known = {
                step.name: progress.steps[lesson.name][step.name]
                for step in lesson.steps
                if step.name in progress.steps.get(lesson.name, {})
            }
            if known:
                found.append(
                    _line(progress.pupil, lesson.name, dict(lesson.title), list(known.values()), len(lesson.steps))
                )
        done = [step for name in progress.steps if name in drill_names for step in progress.steps[name].values()]
        if done:
            found.append(_line(progress.pupil, DRILLS, _both("report.drills"), done, len(faults)))
        for name, steps in progress.steps.items():
            if name not in known_names and steps:
                title = {each: Say("report.not_there", name=name).text(each) for each in LANGUAGES}
                found.append(_line(progress.pupil, name, title, list(steps.values()), len(steps)))
        if len(found) == before:  # also where only steps are known that the lessons do not have any more
            found.append(_line(progress.pupil, "", dict.fromkeys(LANGUAGES, "-"), [], 0))
    return found


def _both(key: str) -> dict[str, str]:
    return {each: Say(key).text(each) for each in LANGUAGES}


def _line(pupil: str, lesson: str, title: dict[str, str], done: list[StepDone], steps: int) -> ReportLine:
    return ReportLine(
        pupil,
        lesson,
        title,
        sum(bool(step.solved) for step in done),
        steps,
        sum(step.passed_over and not step.solved for step in done),
        sum(step.hints for step in done),
        sum(step.refused for step in done),
        sum(step.seconds for step in done),
        max((step.solved for step in done), default=0.0),
    )


def heads(language: str) -> list[str]:
    """The names of the columns."""
    return [Say(f"report.{column}").text(language) for column in COLUMNS]


def cells(line: ReportLine, language: str, *, short: bool = False) -> list[object]:
    """A line's cells; `short` for a terminal of 80 columns: lessons by their names."""
    title = line.lesson if short and line.lesson not in ("", DRILLS) else line.title[language]
    solved = Cell(f"{line.solved}/{line.steps}", "good" if line.steps and line.solved == line.steps else "")
    return [
        line.pupil, title, solved, line.passed_over, line.hints, line.refused,
        round(line.seconds / 60, 1), moment(line.last) or Say("report.never").text(language),
    ]  # fmt: skip


def moment(seconds: float) -> str:
    """A time as people write it, '' for none."""
    if seconds <= 0:
        return ""
    try:
        return time.strftime("%Y-%m-%d %H:%M", time.localtime(seconds))
    except (OverflowError, OSError, ValueError):
        return ""
