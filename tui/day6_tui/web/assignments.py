"""Assignments as they are kept: DATA/assignments/ID, which only the server's user can enter. Everything is written whole.

    assignment.json             what it is, for whom, until when, who has it
    files/…                     what a folder that is handed out begins with
    collected/PUPIL/WHEN.zip    a pupil's work, as `day6-tui grade` takes it; a new collection is a new file
    collected/PUPIL/WHEN.json   how it was graded
    marks.json                  the teacher's own: a mark and a line for each pupil, and what was given back when

So there is no moment at which a killed server or a full disk would lose what was collected. Everything here blocks.
"""

from __future__ import annotations

import contextlib
import json
import os
import re
import time
from collections.abc import Iterator, Mapping
from dataclasses import asdict, dataclass, field, replace
from pathlib import Path
from typing import Any

from day6_core.classroom.homes import folder_name, same_name
from day6_core.lessons import work
from day6_core.lessons.work import Task
from day6_core.whole_file import make_private_folder, write_private

MOST_ASSIGNMENTS = 100
LONGEST_MARK, LONGEST_LINE, LONGEST_TITLE = 20, 500, 80
LARGEST = 4_000_000
"""Bytes of a file of ours that is read."""
_ID = re.compile(r"[a-z0-9][a-z0-9-]{0,60}\Z")
_STAMP = re.compile(r"\d{8}T\d{6}\d{3}Z(-\d+)?\Z")


class TooMany(Exception):
    """There are as many assignments as there may be."""


@dataclass(frozen=True)
class Assignment:
    """What was handed out. Times are seconds since 1970."""

    id: str
    task: Task
    title: Mapping[str, str]
    """By language."""
    to: tuple[str, ...] | None = None
    """None: all, also who comes later."""
    due: float = 0.0
    """0: whenever."""
    made: float = 0.0
    closed: bool = False
    """Nobody gets it any more, and nobody's work is looked at."""
    due_taken: bool = False
    """Whether everybody's work was collected when it was due."""
    given: Mapping[str, float] = field(default_factory=dict)
    """Who has got it, and when."""

    def is_for(self, name: str) -> bool:
        """Whether this pupil is meant to do it."""
        return self.to is None or same_name(name) in map(same_name, self.to)


@dataclass(frozen=True)
class Collected:
    """One collection of one pupil's work."""

    file: Path
    pupil: str
    when: float
    print: str
    """See `work.fingerprint`."""
    late: bool = False
    begun: bool = True
    """Whether anything in it is of the task, as far as the desktop has noted."""
    count: int = 0
    """Files in it."""
    left_out: int = 0
    solved: int = 0
    """Steps, or drills of an exam, as the desktop has noted."""
    grade: Mapping[str, Any] | None = None


@dataclass(frozen=True)
class Word:
    """What the teacher says of a pupil's work."""

    mark: str = ""
    line: str = ""
    returned: float = 0.0
    """When it was given back; 0: not yet."""
    print: str = ""
    """What the text that was given back was about: something else now means it should be given back again."""


class AssignmentStore:
    """All assignments of a class."""

    def __init__(self, folder: Path) -> None:
        self._folder = folder

    # -- assignments ---------------------------------------------------------------------------------------------------

    def all(self) -> list[Assignment]:
        """Every assignment that can be read, the oldest first."""
        found = []
        for path in sorted(self._folder.glob("*/assignment.json")):
            with contextlib.suppress(OSError, ValueError, KeyError, TypeError):
                found.append(_assignment(path.parent.name, _json(path)))
        return sorted(found, key=lambda each: (each.made, each.id))

    def new(self, task: Task, title: Mapping[str, str], to: tuple[str, ...] | None, due: float) -> Assignment:
        """Make a folder for one. Raises TooMany, OSError."""
        make_private_folder(self._folder)
        plain = re.sub(r"[^a-z0-9]+", "-", task.name.rpartition("/")[2].casefold()).strip("-")[:30] or task.kind
        for number in range(1, MOST_ASSIGNMENTS + 1):
            name = plain if number == 1 else f"{plain}-{number}"
            with contextlib.suppress(FileExistsError):
                (self._folder / name).mkdir(mode=0o700)
                return Assignment(name, task, title, to, due, round(time.time(), 3))
        raise TooMany

    def keep(self, assignment: Assignment) -> None:
        """Write it down. Raises OSError."""
        data = {name: each for name, each in asdict(assignment).items() if name not in ("id", "task")}
        data |= {"version": 1, "kind": assignment.task.kind, "names": assignment.task.names}
        _write(self._folder / assignment.id / "assignment.json", data)

    def put_file(self, id_: str, path: str, data: bytes) -> None:
        """Keep a file of a folder that is handed out. Raises OSError."""
        write_private(self._of(id_) / "files" / path, data)

    def files(self, id_: str) -> dict[str, bytes]:
        """What a folder begins with. Raises OSError."""
        top = self._of(id_) / "files"
        return {
            path.relative_to(top).as_posix(): path.read_bytes() for path in sorted(top.rglob("*")) if path.is_file()
        }

    def _of(self, id_: str) -> Path:
        if not _ID.match(id_):
            raise ValueError(id_)
        return self._folder / id_

    # -- what was collected --------------------------------------------------------------------------------------------

    def collect(self, id_: str, name: str, packed: bytes, when: float) -> Collected:
        """Keep a pupil's packed work as a new file. Raises OSError; then nothing of it is left."""
        folder = self._of(id_) / "collected" / folder_name(name)
        make_private_folder(folder.parent.parent)
        make_private_folder(folder)
        stamp = time.strftime("%Y%m%dT%H%M%S", time.gmtime(when)) + f"{int(when % 1 * 1000):03}Z"
        names = (f"{stamp}{'' if number == 1 else f'-{number}'}" for number in range(1, 1000))
        file = next(path for each in names if not os.path.lexists(path := folder / f"{each}.zip"))
        write_private(file, packed)
        return _collected(file)

    def everybodys(self, id_: str) -> list[Collected]:
        """The last collection of everybody's work."""
        folders = sorted((self._of(id_) / "collected").glob("*"))
        return [last for folder in folders if (last := next(_in(folder), None)) is not None]

    def keep_grade(self, collected: Collected, grade: Mapping[str, Any]) -> Collected:
        """Write down how it was graded. Raises OSError."""
        _write(collected.file.with_suffix(".json"), {"version": 1, **grade})
        return replace(collected, grade=dict(grade))

    # -- the teacher's own ---------------------------------------------------------------------------------------------

    def words(self, id_: str) -> dict[str, Word]:
        """By `same_name` of the pupils. A file that is not ours any more is kept under another name. Raises OSError."""
        path = self._of(id_) / "marks.json"
        try:
            return {str(name): _word(each) for name, each in dict(_json(path)["pupils"]).items()}
        except FileNotFoundError:
            return {}
        except (ValueError, KeyError, TypeError):
            path.replace(path.with_name(f"marks-unreadable-{time.time():.0f}.json"))
            return {}

    def keep_words(self, id_: str, words: Mapping[str, Word]) -> None:
        """Write them down. Raises OSError."""
        _write(
            self._of(id_) / "marks.json", {"version": 1, "pupils": {name: asdict(each) for name, each in words.items()}}
        )


def _in(folder: Path) -> Iterator[Collected]:
    """The collections in a folder that can be read, the newest first."""
    stamps = (path for path in folder.glob("*.zip") if _STAMP.match(path.stem))
    for file in sorted(stamps, key=_order, reverse=True):
        with contextlib.suppress(OSError, ValueError, KeyError, TypeError):
            yield _collected(file)


def _order(file: Path) -> tuple[str, int]:
    stamp, _, number = file.stem.partition("-")
    return stamp, int(number or 1)


def _collected(file: Path) -> Collected:
    """Raises OSError, ValueError, KeyError, TypeError."""
    about = work.manifest_of(file)
    note = about[work.NOTED]
    grade = None
    with contextlib.suppress(OSError, ValueError):
        grade = _json(file.with_suffix(".json"))
    return Collected(
        file, str(about["pupil"]), float(about["when"]), str(about["print"]), about["late"] is True, about["begun"] is True,
        int(about["count"]), int(about["left_out"]), int(note.get("solved", 0)), grade,
    )  # fmt: skip


def _assignment(id_: str, found: Mapping[str, Any]) -> Assignment:
    """Raises ValueError, KeyError, TypeError."""
    if not _ID.match(id_) or found["kind"] not in work.KINDS or not found["names"]:
        raise ValueError(id_)
    return Assignment(
        id_, Task(str(found["kind"]), tuple(map(str, found["names"]))),
        {str(language): str(text) for language, text in dict(found["title"]).items()},
        None if found["to"] is None else tuple(map(str, found["to"])),
        float(found["due"]), float(found["made"]), found["closed"] is True, found["due_taken"] is True,
        {str(name): float(when) for name, when in dict(found["given"]).items()},
    )  # fmt: skip


def _word(found: Mapping[str, Any]) -> Word:
    """Raises ValueError, KeyError, TypeError."""
    return Word(str(found["mark"]), str(found["line"]), float(found["returned"]), str(found["print"]))


def _json(path: Path) -> dict[str, Any]:
    """Raises OSError, ValueError."""
    with open(path, "rb") as file:
        data = file.read(LARGEST + 1)
    found = json.loads(data)
    if len(data) > LARGEST or not isinstance(found, dict):
        raise ValueError(str(path))
    return found


def _write(path: Path, data: Mapping[str, Any]) -> None:
    write_private(path, json.dumps(data, ensure_ascii=False, indent=1).encode(errors="replace") + b"\n")
