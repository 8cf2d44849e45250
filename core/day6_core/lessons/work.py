"""A pupil's work on one assignment, packed as `day6-tui grade` takes submissions, with what the desktop has noted of it.

The note is for the teacher's eyes only: whoever can edit a progress file can edit this.
"""

from __future__ import annotations

import hashlib
import io
import json
import time
import zipfile
from collections.abc import Collection, Mapping, Sequence
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

from day6_core.lessons.belongings import belonging, folders, is_known, owners
from day6_core.lessons.grading.archive import LARGEST, MANIFEST, VERSION, fits
from day6_core.lessons.progress import Progress
from day6_core.lessons.submission import LOOSE

SOURCE = "ros2_ws/src/"
NOTED = "noted"
"""In the manifest: what the desktop has noted."""
MOST_TOLD = 20
"""Names of files that are left out are kept."""
MOST_STEPS, LONGEST_STEP = 200, 100
"""Of a lesson are kept, and characters of a step's name: the progress file is the pupil's."""

LESSON, DRILL, EXAM, FOLDER = KINDS = ("lesson", "drill", "exam", "folder")


class TooLarge(Exception):
    """It is more than a submission may be."""


@dataclass(frozen=True)
class Task:
    """What pupils are to do: the name of a lesson, a drill or a folder, or the drills of an exam."""

    kind: str
    names: tuple[str, ...]

    @property
    def name(self) -> str:
        return self.names[0]


@dataclass
class Work:
    """What was found in a home: files by their paths, and progress."""

    files: Mapping[str, bytes] = field(default_factory=dict)
    left_out: Sequence[str] = ()
    progress: Progress = field(default_factory=Progress)


def wanted_of(task: Task) -> list[tuple[str, bool, tuple[str, ...]]]:
    """The folders of a home in which the work is: each with whether what is below it counts, and the endings of loose files."""
    if task.kind == FOLDER:
        return [(task.name, True, ())]
    return [
        ("", False, LOOSE),
        ("ros2_ws/src", True, LOOSE),
        *((each, True, ()) for each in sorted(folders(task.names))),
    ]


def noted(task: Task, progress: Progress) -> dict[str, Any]:
    """What the desktop has noted of the task: steps that are solved and their answers, or how the exam went."""
    if task.kind == FOLDER:
        return {}
    if task.kind == EXAM:
        rows = [each["drills"] for each in progress.exams if _is_of(task, each)]
        results = [_result(each) for each in rows[-1]] if rows else []
        return {"solved": sum(each.get("solved") is True for each in results), "exam": results}
    known = progress.steps.get(task.name, {})
    steps = {name: known[name] for name in list(known)[:MOST_STEPS] if len(name) <= LONGEST_STEP}
    return {
        "solved": sum(bool(each.solved) for each in steps.values()),
        "hints": sum(each.hints for each in steps.values()),
        "answers": {name: each.answers for name, each in steps.items() if each.answers},
        "steps": {name: bool(each.solved) for name, each in steps.items()},
    }


def _result(row: Mapping[str, Any]) -> dict[str, Any]:
    """How a drill of an exam went, whatever else somebody has written there."""
    numbers = {name: row.get(name) for name in ("seconds", "hints")}
    good = {name: each for name, each in numbers.items() if isinstance(each, (int, float)) and 0 <= each < 1e9}
    return {"drill": row.get("drill"), "solved": row.get("solved") is True, **good}


def _is_of(task: Task, exam: Mapping[str, Any]) -> bool:
    rows = exam.get("drills")
    good = isinstance(rows, list) and all(isinstance(each, dict) for each in rows)
    return good and tuple(each.get("drill") for each in rows or ()) == task.names


def has_begun(task: Task, work: Work) -> bool:
    """Whether there is anything of this task. A program counts where it belongs to no earlier lesson."""
    if task.kind == FOLDER:
        return bool(work.files)
    if task.kind == LESSON and any(owners(path)[:1] == [task.name] for path in work.files):
        return True
    found = noted(task, work.progress)
    return bool(found.get("solved") or found.get("steps") or found.get("exam"))


def fingerprint(task: Task, work: Work) -> str:
    """Another word after every change of the work. What belongs to other lessons alone is no part of it."""
    told = hashlib.sha256(json.dumps(noted(task, work.progress), sort_keys=True).encode())
    ours = _ours(task, work)
    for path, data in sorted(work.files.items()):
        if path in ours:
            told.update(f"\n{path}\n".encode(errors="surrogateescape") + hashlib.sha256(data).digest())
    return told.hexdigest()


def _ours(task: Task, work: Work) -> Collection[str]:
    """The files that are of this task: all where that is not known."""
    if task.kind == FOLDER or not all(map(is_known, task.names)):
        return work.files
    return belonging(task.names, work.files)


def pack(task: Task, work: Work, pupil: str, home: str, **about: object) -> bytes:
    """One zip that `day6-tui grade` takes. `about` is kept in its manifest. Raises TooLarge."""
    note, left_out = noted(task, work.progress), list(work.left_out)
    answers = {task.name: note["answers"]} if note.get("answers") else {}
    file = io.BytesIO()
    with zipfile.ZipFile(file, "w", zipfile.ZIP_DEFLATED) as archive:
        count = 0
        for path, data in sorted(work.files.items()):
            if fits(name := _packed_name(path)):
                archive.writestr(name, data)
                count += 1
            else:
                left_out.append(path)
        manifest = {
            "version": VERSION, "pupil": pupil, "home": home, "made": int(time.time()), "answers": answers, NOTED: note,
            "begun": has_begun(task, work), "print": fingerprint(task, work), "count": count, "left_out": len(left_out),
            "left_out_names": left_out[:MOST_TOLD], **about,
        }  # fmt: skip
        archive.writestr(MANIFEST, json.dumps(manifest, ensure_ascii=True, indent=1))
    if file.tell() > LARGEST:
        raise TooLarge
    return file.getvalue()


def _packed_name(path: str) -> str:
    if path.startswith(SOURCE):
        inside = path[len(SOURCE) :]
        return f"{'src' if '/' in inside else 'loose'}/{inside}"
    return f"{'folder' if '/' in path else 'home'}/{path}"


def manifest_of(file: Path) -> dict[str, Any]:
    """What a packed work says of itself. Raises OSError, ValueError, KeyError."""
    try:
        with zipfile.ZipFile(file) as archive:
            found = json.loads(archive.read(MANIFEST))
    except zipfile.BadZipFile as error:
        raise ValueError(str(error)) from None
    if not isinstance(found, dict):
        raise ValueError("no manifest")
    return found
