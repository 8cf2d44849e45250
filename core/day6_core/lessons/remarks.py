"""What `lessons check` tells of a lesson that can be read: what a class would meet, and what is a matter of taste (a warning)."""

from __future__ import annotations

from day6_core.language import LANGUAGES
from day6_core.lessons.document import Lesson, Step
from day6_core.lessons.flaws import MarkedMap, line_of, meant
from day6_core.lessons.source import LessonSource
from day6_core.width import text_width

MOST_TITLE = 60
"""Columns of a title."""

MOST_DO = 600
"""Characters of what is to be done: one thing."""

DRILL_WRONG = 3
FAULTS = 46
"""The faults of the list that the shipped drills are of."""

TOPICS = (
    "environment", "workspace", "package", "code", "names", "types", "qos", "parameters", "services", "tf", "rviz", "time",
    "network",
)  # fmt: skip
"""The topics of drills, in the order in which they are listed; others come last."""


def note_remarks(source: LessonSource, head: MarkedMap, lesson: Lesson) -> None:
    """Judge a lesson that was read as far as it goes; `head` is its front matter."""
    for language, text in lesson.title.items():
        _judge_title(source, line_of(head.get("title"), language) or 1, text)
    if lesson.is_drill:
        _judge_drill(source, head, lesson)
    else:
        for key in ("fault", "topic"):
            if key in head:
                source.remark(line_of(head, key), f"'{key}' is for drills: this file has 'lesson:'")
    for step in lesson.steps:
        _judge_step(source, step, drill=lesson.is_drill)


def _judge_drill(source: LessonSource, head: MarkedMap, lesson: Lesson) -> None:
    if "fault" in head and not 1 <= lesson.fault <= FAULTS:
        told = f"'fault' is a number of the list of faults, 1 to {FAULTS}: leave it out in a drill of your own"
        source.remark(line_of(head, "fault"), told)
    if lesson.topic not in TOPICS:
        told = f"topic '{lesson.topic}'" if lesson.topic else "'topic' is missing"
        source.remark(line_of(head, "topic") or 1, told + meant(lesson.topic, TOPICS), warning=True)
    for step in lesson.steps:
        if not step.broken and not step.before:
            source.remark(step.line, "a drill needs 'before': actions that make the fault")
        if not step.broken and len(step.wrong) < DRILL_WRONG:
            told = f"a drill needs {DRILL_WRONG} wrong answers, there are {len(step.wrong)}"
            source.remark(step.lines.get("wrong", step.line), told)


def _judge_step(source: LessonSource, step: Step, *, drill: bool) -> None:
    if not step.broken and not step.lines.get("solve"):
        told = f"step '{step.name}' has no 'solve': it cannot be shown, played or made ready for a later one"
        source.remark(step.line, told)
    if not step.broken and not step.wrong and not drill:
        source.remark(step.line, f"step '{step.name}' has no wrong answer: nothing shows what it refuses", warning=True)
    for language in LANGUAGES:
        page = step.pages.get(language)
        if page is None:
            continue
        where = f"step '{step.name}', {language}"
        _judge_title(source, step.line, page.title)
        if not page.picture:
            source.remark(step.line, f"{where}: there is no picture of what will be seen", warning=True)
        if len(page.do) > MOST_DO:
            told = f"{where}: '### do' is long ({len(page.do)} characters): it is one thing to do"
            source.remark(step.line, told, warning=True)


def _judge_title(source: LessonSource, line: int, title: str) -> None:
    wide = text_width(title)
    if wide > MOST_TITLE:
        source.remark(line, f"a title of {wide} columns: the most are {MOST_TITLE}")
