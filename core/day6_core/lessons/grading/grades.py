"""What is known of submissions: one plain structure, of which every table is made (`Graded.data`)."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

from day6_core.lessons.grading.marks import Mark, Seen
from day6_core.lessons.lag import STALL, Lag, worst_of
from day6_core.lessons.texts import Say

ANSWERS = "answers"
"""The scenario that is not played: the letters chosen at the questions of a lesson."""

Texts = Mapping[str, str]
"""The same in each language."""


@dataclass
class Grade:
    """How one scenario went. `checks` are what was asked and seen, as `Seen.data` writes it."""

    lesson: str
    scenario: str
    title: Texts
    mark: Mark = Mark.UNPLAYED
    points: float = 0.0
    most: float = 1.0
    checks: list[dict[str, Any]] = field(default_factory=list)
    seconds: float = 0.0
    stood_still: float = 0.0
    """The longest time for which the machine let it wait, if that was too long."""

    began: float | None = field(default=None, repr=False)
    ended: float | None = field(default=None, repr=False)
    lag: Lag = field(default_factory=Lag, repr=False)
    cpu: float = field(default=0.0, repr=False)
    timed: bool = field(default=True, repr=False)
    stall: float = field(default=STALL, repr=False)
    """Seconds for which a busy machine may hold it up."""

    @property
    def passed(self) -> bool:
        return self.mark is Mark.RIGHT

    @property
    def problems(self) -> list[tuple[Texts, Texts]]:
        """What was asked and not seen, and what was seen instead."""
        return [(each["asked"], each["seen"]) for each in self.checks if not each["ok"]]

    def note(self, said: Mapping[str, Any]) -> None:
        """Take what the judge says of it when it begins, and when it has ended."""
        if "began" in said:
            self.began = said["began"]
            return
        self.mark, self.points, self.checks = Mark(said["mark"]), said["points"], said["checks"]
        self.seconds, self.ended, self.lag = said["seconds"], said["ended"], Lag(*said["lag"])
        self.cpu, self.timed = said["cpu"], said["timed"]

    def conclude(self, mark: Mark, asked: Say, seen: Say) -> None:
        """Mark what no check could tell."""
        self.mark, self.points, self.checks = mark, 0.0, [Seen(asked, seen).data()]

    def look_for_lag(self, stalls: list[list[float]], ended: float) -> None:
        """Whether the machine kept up while it was played. `stalls`: when other processes had to wait, and for how long."""
        if self.began is not None and self.timed:
            end = ended if self.ended is None else self.ended
            beside = [late for at, late in stalls if self.began <= at <= end]
            self.stood_still = worst_of(end - self.began, self.lag, beside, self.cpu, self.stall)

    def data(self) -> dict[str, Any]:
        """As it is written down."""
        kept = ("lesson", "scenario", "title", "points", "most", "checks", "seconds", "stood_still")
        return {**{name: getattr(self, name) for name in kept}, "mark": self.mark.value}


@dataclass
class Graded:
    """One submission. `refused` is why it was not looked at; `pupil` is what it calls itself."""

    file: Path
    pupil: str = ""
    refused: Texts | None = None
    results: list[Grade] = field(default_factory=list)
    ended: str = ""
    problem: str = ""
    """What failed in the grader itself."""

    shielded: bool = True
    seconds: float = 0.0
    stalls: list[list[float]] = field(default_factory=list)
    """When the machine let the warden wait, and for how long."""

    @property
    def passed(self) -> int:
        return sum(result.passed for result in self.results)

    @property
    def lagged(self) -> list[Grade]:
        """What went wrong, or not to its end, while the machine stood still."""
        return [result for result in self.results if not result.passed and result.stood_still]

    def data(self) -> dict[str, Any]:
        """As it is written down: all tables are made of this."""
        return {
            "file": self.file.name, "calls_itself": self.pupil, "refused": self.refused, "seconds": self.seconds,
            "points": round(sum(each.points for each in self.results), 2), "most": sum(each.most for each in self.results),
            "unplayed": sum(each.mark is Mark.UNPLAYED for each in self.results),
            "scenarios": [each.data() for each in self.results],
        }  # fmt: skip
