"""`day6-tui report`: how far all pupils of this machine are, for a teacher; on the terminal, as CSV, as a page."""

from __future__ import annotations

import os
import sys
import time
from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path

from day6_core.language import LANGUAGES, language_of
from day6_core.lessons import parsers
from day6_core.lessons.catalogue import offer
from day6_core.lessons.document import Lesson
from day6_core.lessons.progress import FOLDER, Progress, ProgressError, StepDone, load
from day6_core.lessons.tables import (
    Cell,
    Exists,
    csv_bytes,
    html_page,
    html_table,
    html_text,
    must_be_new,
    text_table,
    write_table,
)
from day6_core.lessons.texts import Say
from day6_core.places import default_home
from day6_core.reason import reason
from day6_core.session.harmless import one_line

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
        known_names = drill_names | {lesson.name for lesson in lessons}
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
    return [
        line.pupil, title, f"{line.solved}/{line.steps}", line.passed_over, line.hints, line.refused,
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


def page(found: list[ReportLine], language: str, folder: Path, now: float) -> bytes:
    """The HTML page."""
    title = Say("report.title").text(language)
    rows = []
    for line in found:
        row = cells(line, language)
        row[2] = Cell(row[2], "good" if line.steps and line.solved == line.steps else "")
        rows.append(row)
    made = Say("report.made", when=moment(now), folder=str(folder)).text(language)
    honest = Say("report.honest").text(language)
    parts = [html_text(title, "h1"), html_table(heads(language), rows), html_text(made), html_text(honest)]
    return html_page(title, language, parts)


def _pupils(folder: Path) -> tuple[list[Progress], list[tuple[Path, str]]]:
    """The pupils by name, and the files that cannot be used."""
    found, broken = [], []
    for path in sorted(folder.glob("*.json")):
        try:
            progress = load(path)
        except ProgressError as error:
            broken.append((path, str(error)))
        except OSError as error:
            broken.append((path, reason(error)))
        else:
            progress.pupil = progress.pupil or path.stem
            found.append(progress)
    return found, broken


def main(arguments: list[str]) -> int:
    """Run `day6-tui report ARGUMENTS`; returns the exit status."""
    language = language_of(os.environ, arguments)
    options = parsers.report(language).parse_args(arguments)

    def tell(key: str, **values: object) -> int:
        print(one_line(f"day6-tui report: {Say(key, **values).text(language)}"), file=sys.stderr)
        return 1

    folder = (options.home or default_home()).expanduser().resolve() / FOLDER
    pupils, broken = _pupils(folder)
    for path, why in broken:
        tell("report.broken", file=path, reason=why)
    if not pupils:
        return tell("report.none", folder=folder)
    offered = offer(options.lessons)
    found = lines_of(pupils, offered.lessons, offered.drills)
    try:
        must_be_new([options.csv, options.html], options.force)
        if options.csv is not None:
            write_table(
                options.csv, csv_bytes(heads(language), (cells(line, language) for line in found)), options.force
            )
        if options.html is not None:
            write_table(options.html, page(found, language, folder, time.time()), options.force)
    except Exists as error:
        return tell("office.exists", file=error)
    except OSError as error:
        return tell("office.failed", file=error.filename or "", reason=reason(error))
    for path in (options.csv, options.html):
        if path is not None:
            print(one_line(Say("office.written", file=path).text(language)))
    if options.csv is None and options.html is None:
        print(text_table(heads(language), (cells(line, language, short=True) for line in found)))
        print(f"\n{Say('report.honest').text(language)}")
    return 1 if broken else 0
