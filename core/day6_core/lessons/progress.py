"""How far a pupil is: kept in one file per pupil, written whole after every step, joined with what another desktop wrote.

It tells where to go on, not what somebody can: whoever can edit a file can edit this one, so nothing is graded by it.
"""

from __future__ import annotations

import json
import time
from collections.abc import Iterator
from contextlib import contextmanager, suppress
from dataclasses import asdict, dataclass, field, replace
from pathlib import Path
from typing import Any

from day6_core.link.file_lock import FileLock
from day6_core.whole_file import make_private_folder, write_private

VERSION = 1
LARGEST = 4_000_000
"""Bytes of a progress file that is read."""
MOST_STEPS, MOST_EXAMS = 20_000, 500
"""Of a file: whoever can edit it may have made it up, and a server reads those of a whole class."""

LONGEST_NAME = 40
LONGEST_ANSWERS = 40
PATIENCE = 2.0
"""Seconds to wait for another desktop that is saving."""

FOLDER = Path(".config", "day6-tui", "pupils")
"""In the home folder of the machine."""


class ProgressError(Exception):
    """A progress file that cannot be used; it is left as it is."""


@dataclass(frozen=True)
class StepDone:
    """What is known of one step. Times are seconds since 1970, 0: not yet."""

    solved: float = 0.0
    passed_over: bool = False
    hints: int = 0
    seconds: float = 0.0
    """How long it took, from first seen to solved."""

    refused: int = 0
    """Wrong answers to a question."""

    answers: str = ""
    """The letters that were chosen at a question, in their order."""

    def joined(self, other: StepDone) -> StepDone:
        """What two desktops know together: the first solution counts."""
        if self.solved and other.solved:
            return self if self.solved <= other.solved else other
        if self.solved or other.solved:
            return self if self.solved else other
        return replace(
            self,
            passed_over=self.passed_over or other.passed_over,
            hints=max(self.hints, other.hints),
            seconds=max(self.seconds, other.seconds),
            refused=max(self.refused, other.refused),
            answers=max(self.answers, other.answers, key=len),
        )


@dataclass
class Progress:
    """All that is kept of one pupil. `at`: the step at which each lesson goes on; `last`: the lesson of the last time."""

    pupil: str = ""
    steps: dict[str, dict[str, StepDone]] = field(default_factory=dict)
    at: dict[str, str] = field(default_factory=dict)
    last: str = ""
    last_title: dict[str, str] = field(default_factory=dict)
    """Of that lesson, by language."""
    changed: float = 0.0
    exams: list[dict[str, Any]] = field(default_factory=list)

    def step(self, lesson: str, step: str) -> StepDone:
        return self.steps.get(lesson, {}).get(step, StepDone())

    def note(self, lesson: str, step: str, done: StepDone) -> None:
        self.steps.setdefault(lesson, {})[step] = done

    def forget(self, lesson: str) -> None:
        """A lesson begins anew: nothing of it is known, and it goes on at its first step."""
        self.steps.pop(lesson, None)
        self.at.pop(lesson, None)

    def solved(self, lesson: str) -> int:
        """How many steps of a lesson are solved."""
        return sum(bool(step.solved) for step in self.steps.get(lesson, {}).values())

    def copy(self) -> Progress:
        """One that nobody changes."""
        steps = {lesson: dict(known) for lesson, known in self.steps.items()}
        return replace(self, steps=steps, at=dict(self.at), exams=list(self.exams))

    def joined(self, other: Progress) -> Progress:
        """This one with what another desktop of the same pupil has saved meanwhile."""
        steps = {name: dict(known) for name, known in other.steps.items()}
        for lesson, known in self.steps.items():
            for name, done in known.items():
                before = steps.setdefault(lesson, {}).get(name)
                steps[lesson][name] = done if before is None else done.joined(before)
        exams = other.exams + [each for each in self.exams if each not in other.exams]
        newer = self if self.last else other
        at = {**other.at, **self.at}
        return replace(self, steps=steps, at=at, last=newer.last, last_title=newer.last_title, exams=exams)


def file_of(home: Path, pupil: str) -> Path:
    """The progress file of a pupil in a machine's home folder."""
    return home / FOLDER / f"{safe_name(pupil)}.json"


def safe_name(pupil: str) -> str:
    """A name as a file's: letters and digits of any script stay, the rest is written by number."""
    kept = "".join(char if char.isalnum() or char in "-_" else f"%{ord(char):x}" for char in pupil.strip())
    return kept or "pupil"


def name_mistake(pupil: str) -> str:
    """What is wrong with a pupil's name: 'empty', 'long' or 'control', '' if nothing is."""
    name = pupil.strip()
    if not name:
        return "empty"
    if len(name) > LONGEST_NAME or len(safe_name(name).encode()) > 200:
        return "long"
    return "" if name.isprintable() else "control"


def load(path: Path) -> Progress:
    """Read a progress file; a new one where there is none. Raises ProgressError, OSError."""
    try:
        if path.stat().st_size > LARGEST:
            raise ProgressError("too large")
        return decode(path.read_bytes())
    except FileNotFoundError:
        return Progress()


def decode(text: bytes) -> Progress:
    """Read what is in a progress file. Raises ProgressError."""
    try:
        data = json.loads(text.decode("utf-8"))
    except (ValueError, RecursionError) as error:  # also a number of more digits than Python takes
        raise ProgressError(f"not JSON: {error}") from None
    if not isinstance(data, dict) or not isinstance(data.get("version"), int):
        raise ProgressError("no progress of day6-tui")
    if data["version"] > VERSION:
        raise ProgressError(f"written by a newer day6-tui (version {data['version']})")
    if sum(1 + len(_dict(known)) for known in _dict(data.get("steps")).values()) > MOST_STEPS:
        raise ProgressError("too large")
    return _progress_of(data)


def _progress_of(data: dict[str, Any]) -> Progress:
    """Whatever makes sense in the file; the rest is left out."""
    progress = Progress(_text(data.get("pupil")), last=_text(data.get("last")), changed=_number(data.get("changed")))
    for lesson, known in _dict(data.get("steps")).items():
        progress.steps[lesson] = {
            name: StepDone(
                _number(each.get("solved")),
                each.get("passed_over") is True,
                int(_number(each.get("hints"))),
                _number(each.get("seconds")),
                int(_number(each.get("refused"))),
                _text(each.get("answers"))[:LONGEST_ANSWERS],
            )
            for name, each in _dict(known).items()
            if isinstance(each, dict)
        }
    progress.at = {lesson: step for lesson, step in _dict(data.get("at")).items() if isinstance(step, str)}
    titles = _dict(data.get("last_title")).items()
    progress.last_title = {name: text for name, text in titles if isinstance(text, str)}
    exams = data.get("exams")
    some = exams[-MOST_EXAMS:] if isinstance(exams, list) else []
    progress.exams = [each for each in some if isinstance(each, dict)]
    return progress


def _dict(value: object) -> dict[str, Any]:
    return {key: each for key, each in value.items() if isinstance(key, str)} if isinstance(value, dict) else {}


def _text(value: object) -> str:
    return value if isinstance(value, str) else ""


def _number(value: object) -> float:
    if isinstance(value, bool) or not isinstance(value, (int, float)) or not -1e12 < value < 1e12:
        return 0.0
    return float(value)


def save(path: Path, progress: Progress) -> Progress:
    """Join with what the file says and write it, whole or not at all; return what is known now. Blocks; for a thread.

    Raises ProgressError for a file that is not ours to overwrite, OSError.
    """
    make_private_folder(path.parent)
    with _alone(path.with_suffix(".lock")):
        joined = progress.joined(load(path))
        joined.changed = time.time()
        write_private(path, encode(joined))
    return joined


def encode(progress: Progress) -> bytes:
    """Return what is in a progress file. Raises ProgressError: what is in it may have been made up."""
    try:
        return json.dumps({"version": VERSION, **asdict(progress)}, ensure_ascii=False, indent=1).encode()
    except (UnicodeEncodeError, RecursionError) as error:
        raise ProgressError(str(error)) from None


@contextmanager
def _alone(path: Path) -> Iterator[None]:
    """Hold the lock of a pupil's file for a moment.

    One that is held for longer is passed over: files are written whole with or without it, only joining them profits from it.
    """
    lock = FileLock(path)
    deadline = time.monotonic() + PATIENCE
    while not lock.try_acquire() and time.monotonic() < deadline:
        time.sleep(0.02)
    try:
        yield
    finally:
        lock.release()


def pupils(home: Path) -> list[Progress]:
    """All pupils of a machine, by name; files that cannot be used are left out."""
    found = []
    for path in sorted((home / FOLDER).glob("*.json")):
        with suppress(ProgressError, OSError):
            progress = load(path)
            progress.pupil = progress.pupil or path.stem
            found.append(progress)
    return found
