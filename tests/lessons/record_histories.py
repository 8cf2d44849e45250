"""Writes `recorded_histories.jsonl` anew: `python -m tests.lessons.record_histories [WORD…]` plays days and drills for real.

With words only the files whose names begin with one of them; the others stay as they are. To be run by hand, after a lesson or
what checks ask a machine for has changed. `--said`: nothing is played, only what checks say is written anew, after their texts
have changed.
"""

from __future__ import annotations

import os
import sys
import tempfile
from pathlib import Path
from typing import Any

from tests import conftest as surroundings

# isort: split
from day6_core.lessons import rehearsal
from day6_core.lessons.checks import Verdict
from day6_core.lessons.document import Step, Wrong
from day6_core.lessons.reading import read_lesson
from tests.lessons.histories import RECORDED, SHIPPED, judged, otherwise, read_histories, write_histories
from tests.support.recorded_live import RecordingLive, compact

steps: list[Any] = []
"""The steps of the lesson that is played, as far as it is."""


class RecordedRehearsal(rehearsal._Rehearsal):
    """Plays a lesson and takes a moment whenever something else holds, where a wrong answer is refused, and at the end."""

    _live: RecordingLive
    _wrong: Wrong | None = None
    _number = 0

    async def play(self, step: Step) -> rehearsal.Played:
        self._moments: list[Any] = []
        self._last: tuple[bool, ...] | None = None
        played = await super().play(step)
        steps.append({"step": step.name, "moments": self._moments})
        return played

    def _verdicts(self, step: Step) -> list[Verdict]:
        self._live.forget()
        verdicts = super()._verdicts(step)
        now = self._live.signature(step.checks, verdicts)
        if now != self._last:
            self._last = now
            self._take("look", verdicts)
        return verdicts

    def _take(self, what: str, verdicts: list[Verdict]) -> None:
        moment = self._live.moment(verdicts)
        part = "before" if self._now == "before" else "solve" if self._now == "solve" else f"wrong {self._number}"
        self._moments.append({"part": part, "what": what, **moment})

    def _solved(self, step: Step) -> bool:
        verdicts = self._verdicts(step)
        solved = all(verdict.ok for verdict in verdicts)
        if solved and self._now == "solve":
            self._take("solved", verdicts)
        return solved

    def _failing(self, step: Step) -> str:
        verdicts = self._verdicts(step)
        text = "; ".join(verdict.text("en") for verdict in verdicts if not verdict.ok)
        if self._wrong is not None and rehearsal._plain(self._wrong.says) in rehearsal._plain(text):
            self._take("refused", verdicts)
        return text

    async def _refuse(self, step: Step, number: int, wrong: Wrong, played: rehearsal.Played) -> None:
        self._wrong, self._number, self._last = wrong, number, None
        await super()._refuse(step, number, wrong, played)
        self._wrong, self._last = None, None


def play(path: Path) -> Any:
    """Play one file and return its history."""
    steps.clear()
    lesson = read_lesson(path)
    with tempfile.TemporaryDirectory(prefix="d6-", ignore_cleanup_errors=True) as folder:
        surroundings.set_environment({**surroundings.environment(), "DAY6_RUNTIME_DIR": f"{folder}/r"})
        played = rehearsal.rehearse(lesson, Path(folder, "home"))
    faults = [f"{each.step}: {fault}" for each in played for fault in each.faults]
    if faults:
        raise ValueError("; ".join(faults))
    for step, told in zip(lesson.steps, steps, strict=True):
        try:
            moments = compact(told["moments"], lambda moments, step=step: otherwise(step, moments, path.parent))
        except ValueError as error:
            raise ValueError(f"{step.name}: {error}") from None
        verdicts = judged(step, moments, path.parent)  # of what is kept: how many messages came is another number now
        told["moments"] = [{**moment, "verdicts": each} for moment, each in zip(moments, verdicts, strict=True)]
    return {"file": path.name, "steps": list(steps)}


def say_anew() -> int:
    """Write down how the recorded verdicts are said now. They may not hold otherwise than before."""
    steps = {(path.name, step.name): (step, path.parent) for path in SHIPPED for step in read_lesson(path).steps}
    histories = read_histories()
    for history in histories:
        for told in history["steps"]:
            step, folder = steps[history["file"], told["step"]]
            for moment, verdicts in zip(told["moments"], judged(step, told["moments"], folder), strict=True):
                if [each[0] for each in verdicts] != [each[0] for each in moment["verdicts"]]:
                    print(f"{history['file']}: {step.name} is judged otherwise: play it again")
                    return 1
                moment["verdicts"] = verdicts
    write_histories(histories)
    return 0


def main() -> int:
    words = tuple(sys.argv[1:])
    if words == ("--said",):
        return say_anew()
    rehearsal.Live, rehearsal._Rehearsal = RecordingLive, RecordedRehearsal  # type: ignore[misc]
    failed = 0
    for path in SHIPPED:
        if words and not path.name.startswith(words):
            continue
        try:
            history = play(path)
        except (ValueError, TimeoutError) as error:
            failed += 1
            print(f"{path.name}: {error}", flush=True)
            continue
        histories = {each["file"]: each for each in (read_histories() if RECORDED.exists() else ())}
        histories[path.name] = history
        write_histories([histories[each.name] for each in SHIPPED if each.name in histories])
        count = sum(len(each["moments"]) for each in history["steps"])
        print(f"{path.name}: {len(history['steps'])} steps, {count} moments", flush=True)
    return 1 if failed else 0


if __name__ == "__main__":
    status = main()
    sys.stdout.flush()
    os._exit(status)  # threads of the machines that were played don't matter any more
