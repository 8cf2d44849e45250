"""Where a pupil is in a lesson: what the lesson window shows. It is replaced as a whole."""

from __future__ import annotations

from dataclasses import dataclass

from day6_core.lessons.checks import Verdict
from day6_core.lessons.document import Lesson, Step
from day6_core.lessons.source import LessonMistakes


@dataclass(frozen=True)
class State:
    """Where the pupil is."""

    lesson: Lesson | None = None
    index: int = 0
    verdicts: tuple[Verdict, ...] = ()
    solved: bool = False
    before_asked: bool = False
    """Whether it was solved already when the step was opened."""
    done_before: bool = False
    """Whether the pupil has solved it at some time."""
    hints: int = 0
    missing: tuple[str, ...] = ()
    """Earlier steps whose state is needed and not there."""
    leftovers: tuple[str, ...] = ()
    """Nodes that ran already when the lesson was begun, and still run."""
    answer: str = ""
    refused: str = ""
    """The letter of the last wrong answer."""
    working: bool = False
    """Whether something is typed or prepared for the pupil now."""
    problem: str = ""
    """Why something could not be done, in the words of what failed."""
    mistakes: LessonMistakes | None = None
    """The lesson's file was changed and is wrong now; the old text is shown."""
    finished: Lesson | None = None
    """In the list: the lesson whose last step was left just now."""
    unknown: str = ""
    """In the list: the name of a lesson that was asked for and is not there."""

    @property
    def step(self) -> Step | None:
        return self.lesson.steps[self.index] if self.lesson is not None else None

    @property
    def is_last(self) -> bool:
        return self.lesson is not None and self.index == len(self.lesson.steps) - 1
