"""An exam: some drills in a row, with time and hints counted."""

from __future__ import annotations

import random
import time
from collections.abc import Sequence
from dataclasses import dataclass, replace
from typing import Any

from day6_core.lessons.document import Lesson

DRILLS = 5


@dataclass(frozen=True)
class ExamResult:
    """How one drill of an exam went; seconds."""

    drill: str
    solved: bool
    seconds: float
    hints: int


@dataclass(frozen=True)
class Exam:
    """The drills of an exam (names), and the results so far."""

    drills: tuple[str, ...]
    began: float = 0.0
    """Seconds since 1970."""
    results: tuple[ExamResult, ...] = ()

    @property
    def over(self) -> bool:
        return len(self.results) >= len(self.drills)

    @property
    def at(self) -> str:
        """The drill that is next, '' at the end."""
        return "" if self.over else self.drills[len(self.results)]

    @property
    def solved(self) -> int:
        return sum(result.solved for result in self.results)

    def with_result(self, solved: bool, seconds: float, hints: int) -> Exam:
        """With how the drill that is next went."""
        return replace(self, results=(*self.results, ExamResult(self.at, solved, round(seconds, 1), hints)))

    def kept(self) -> dict[str, Any]:
        """As the progress file keeps it."""
        return {
            "began": self.began,
            "drills": [
                {"drill": each.drill, "solved": each.solved, "seconds": each.seconds, "hints": each.hints}
                for each in self.results
            ],
        }


def new_exam(drills: Sequence[Lesson], chance: random.Random | None = None) -> Exam:
    """Choose the drills: of as many topics as there are."""
    dice = random.Random() if chance is None else chance
    by_topic: dict[str, list[str]] = {}
    for drill in dice.sample(list(drills), len(drills)):
        by_topic.setdefault(drill.topic, []).append(drill.name)
    chosen: list[str] = []
    while len(chosen) < min(DRILLS, len(drills)):
        for topic in dice.sample(sorted(by_topic), len(by_topic)):
            if by_topic[topic] and len(chosen) < DRILLS:
                chosen.append(by_topic[topic].pop())
    return Exam(tuple(chosen), round(time.time(), 1))
