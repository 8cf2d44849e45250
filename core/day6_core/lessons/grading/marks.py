"""What a scenario is marked with, and how many points what was seen is worth."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, field
from enum import Enum
from typing import Any

from day6_core.language import LANGUAGES
from day6_core.lessons.checks import Condition, Verdict
from day6_core.lessons.texts import Say


class Mark(str, Enum):
    """How a scenario ended."""

    RIGHT = "right"
    WRONG = "wrong"
    LATE = "late"
    """What there was is right, and the time was over before the rest of it."""

    UNPLAYED = "unplayed"
    """Nothing is known about the submission."""


@dataclass(frozen=True)
class Seen:
    """One thing that was asked, and what was seen: `where` they differ, `at` which second it held."""

    asked: Say
    seen: Say | None = None
    where: Say | None = None
    ok: bool = False
    at: float | None = None

    def data(self) -> dict[str, Any]:
        """As it is written down."""
        texts = {name: both(getattr(self, name)) for name in ("asked", "seen", "where")}
        return {"ok": self.ok, **texts, "at": self.at}


@dataclass(frozen=True)
class Outcome:
    """How a scenario went; `points` is the part of its points that it is worth."""

    mark: Mark
    checks: list[Seen] = field(default_factory=list)
    points: float = 0.0
    timed: bool = True
    """Whether it might have gone otherwise on a machine that is less busy."""

    @property
    def problems(self) -> list[tuple[Say, Say | None]]:
        """What was asked and not seen, and what was seen instead."""
        return [(each.asked, each.seen) for each in self.checks if not each.ok]


def both(say: Say | None) -> dict[str, str]:
    """A text in each language, empty ones for none."""
    return {each: say.text(each) if say is not None else "" for each in LANGUAGES}


def points(
    checks: Sequence[Condition], verdicts: Sequence[Verdict], before: Sequence[Verdict], must: Sequence[str]
) -> float:
    """The part of the points for what holds.

    What held `before` the pupil's program ran earns nothing, it can only be spoilt. Without at least one check of each name in
    `must` there is nothing, nor for what came about in a way that is ruled out.
    """
    held = {each.name for each, verdict in zip(checks, verdicts, strict=True) if verdict.ok}
    if any(verdict.cheated for verdict in verdicts) or not held.issuperset(must):
        return 0.0
    earned = [
        1.0 if now.ok else now.part for now, then in zip(verdicts, before, strict=True) if not (now.ok and then.ok)
    ]
    return round(sum(earned) / len(earned), 2) if earned else 0.0
