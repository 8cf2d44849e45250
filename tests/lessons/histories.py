"""What shipped lessons' checks were told while they were played: read, written, judged again (`recorded_live.py` says how)."""

from __future__ import annotations

import tempfile
from collections.abc import Sequence
from pathlib import Path

from day6_core.lessons.catalogue import HERE
from day6_core.lessons.document import Step
from day6_core.lessons.rehearsal import _plain
from tests.support.recorded_live import Json, judged_again, keys_of, read_lines, say_of, write_lines

RECORDED = Path(__file__).with_name("recorded_histories.jsonl")
"""One lesson a line."""

SHIPPED = [*sorted((HERE / "days").glob("*.md")), *sorted((HERE / "drills").glob("*.md"))]


def read_histories() -> list[Json]:
    return read_lines(RECORDED)


def write_histories(histories: Sequence[Json]) -> None:
    write_lines(RECORDED, histories)


def judged(step: Step, moments: Sequence[Json], folder: Path) -> list[Json]:
    """The verdicts of a step's checks in its moments; `folder`: where the lesson lies."""
    with tempfile.TemporaryDirectory(prefix="d6-") as home:
        return judged_again(moments, step.checks, Path(home), folder)


def otherwise(step: Step, moments: Sequence[Json], folder: Path) -> list[Json]:
    """Moments that the checks judge otherwise than they judged the machine, or refuse for another reason: how they do."""
    return [
        [moment["part"], moment["verdicts"], now]
        for moment, now in zip(moments, judged(step, moments, folder), strict=True)
        if keys_of(moment["verdicts"]) != keys_of(now)
        or (moment["what"] == "refused" and not is_refused(step, moment["part"], now))
    ]


def is_refused(step: Step, part: str, verdicts: Json) -> bool:
    """Whether what does not hold is what this wrong answer is to be refused with."""
    wrong = step.wrong[int(part.removeprefix("wrong ")) - 1]
    failing = "; ".join(_text(each) for each in verdicts if not each[0])
    return _plain(wrong.says) in _plain(failing)


def _text(verdict: Json) -> str:
    return " ".join(say.text("en") for say in map(say_of, verdict[1:]) if say is not None)
