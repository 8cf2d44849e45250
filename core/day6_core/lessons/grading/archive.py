"""Reads a submission, which may be hostile: nothing outside the given folder is touched, and nothing large is unpacked.

What is wrong with it is said in words (`Refused`), for the teacher: no traceback, no half of a submission.
"""

from __future__ import annotations

import json
import os
import re
import stat
import zipfile
import zlib
from dataclasses import dataclass, field
from pathlib import Path, PurePosixPath
from typing import Any

from day6_core.lessons.progress import LONGEST_ANSWERS
from day6_core.lessons.texts import Say
from day6_core.reason import reason

VERSION = 1
MANIFEST = "day6-submission.json"
LARGEST = 20_000_000
"""Bytes of a submission."""

MOST_FILES = 2000
MOST_BYTES = 100_000_000
"""Of all files of a submission, unpacked."""

LARGEST_FILE = 20_000_000
LONGEST_PATH = 240
DEEPEST = 20
LARGEST_MANIFEST = 1_000_000

TOPS = {"src": "ros2_ws/src", "loose": "ros2_ws/src", "home": ".", "folder": "."}
"""The folders of a submission, and where in the home folder they go; `home` and `loose` hold single files, `folder` folders."""

_WORKSPACE = "ros2_ws"

_ENCRYPTED = 1
_LETTERS = re.compile(rf"[a-z]{{1,{LONGEST_ANSWERS}}}\Z")
_TEXTS = (".py", ".xml", ".urdf", ".xacro", ".yaml", ".yml", ".rviz", ".cfg", ".toml", ".txt")
_PIECE = 1 << 16


class SubmissionRefused(Exception):
    """A submission that is not looked at; `say` is why."""

    def __init__(self, say: Say) -> None:
        super().__init__(say.text("en"))
        self.say = say


@dataclass
class Submission:
    """What a submission says of itself. None of it is believed: answers are compared, the rest only shown."""

    pupil: str = ""
    home: str = ""
    answers: dict[str, dict[str, str]] = field(default_factory=dict)


def unpack(path: Path | int, home: Path) -> Submission:
    """Unpack into a home folder, which is empty; a number is that of an open file, closed then. Raises Refused."""
    try:
        if os.stat(path).st_size > LARGEST:
            raise SubmissionRefused(Say("grade.zip.large", megabytes=LARGEST // 1_000_000))
        with open(path, "rb") as file, zipfile.ZipFile(file) as archive:
            entries = _judged(archive)
            submission = _manifest(archive)
            left = MOST_BYTES
            for info, inside in entries:
                left -= _write(archive, info, home / inside, left)
    except SubmissionRefused:
        raise
    except OSError as error:
        raise SubmissionRefused(Say("grade.zip.unread", reason=reason(error))) from None
    except (
        zipfile.BadZipFile,
        zlib.error,
        EOFError,
        NotImplementedError,
        RuntimeError,
        ValueError,
        OverflowError,
    ) as e:
        raise SubmissionRefused(Say("grade.zip.broken", reason=str(e)[:100] or type(e).__name__)) from None
    _translate(submission.home, home, [home / inside for _, inside in entries])
    return submission


def _judged(archive: zipfile.ZipFile) -> list[tuple[zipfile.ZipInfo, PurePosixPath]]:
    """The files and where each goes; all names are judged before anything is written."""
    infos = archive.infolist()
    if len(infos) > MOST_FILES:
        raise SubmissionRefused(Say("grade.zip.many", count=len(infos), most=MOST_FILES))
    if sum(info.file_size for info in infos) > MOST_BYTES:
        raise SubmissionRefused(Say("grade.zip.bomb", megabytes=MOST_BYTES // 1_000_000))
    found: list[tuple[zipfile.ZipInfo, PurePosixPath]] = []
    places: dict[str, str] = {}
    for info in infos:
        name = info.filename
        kind = stat.S_IFMT(info.external_attr >> 16)
        if kind and not (stat.S_ISREG(kind) or stat.S_ISDIR(kind)):
            raise SubmissionRefused(Say("grade.zip.link", name=name[:80]))
        if info.flag_bits & _ENCRYPTED:
            raise SubmissionRefused(Say("grade.zip.locked", name=name[:80]))
        if info.is_dir() or name == MANIFEST:
            continue
        inside = _inside(name)
        if info.file_size > LARGEST_FILE:
            raise SubmissionRefused(Say("grade.zip.file_large", name=name[:80], megabytes=LARGEST_FILE // 1_000_000))
        for part in (inside, *inside.parents):
            before = places.setdefault(str(part), "file" if part == inside else "folder")
            if part == inside and (before == "folder" or any(str(part) == str(each) for _, each in found)):
                raise SubmissionRefused(Say("grade.zip.twice", name=name[:80]))
            if part != inside and before == "file":
                raise SubmissionRefused(Say("grade.zip.twice", name=name[:80]))
        found.append((info, inside))
    return found


def _inside(name: str) -> PurePosixPath:
    """Where a file goes, below the home folder. Raises Refused for a name that leads elsewhere or that nobody needs."""
    parts = name.split("/")
    strange = "\\" in name or ":" in parts[0] or any(ord(char) < 32 or 0xD800 <= ord(char) < 0xE000 for char in name)
    if name.startswith("/") or strange or any(part in ("", ".", "..") for part in parts):
        raise SubmissionRefused(Say("grade.zip.path", name=name[:80]))
    if len(name.encode()) > LONGEST_PATH or len(parts) > DEEPEST:
        raise SubmissionRefused(Say("grade.zip.path", name=name[:80]))
    if not _has_place(*parts):
        raise SubmissionRefused(Say("grade.zip.place", name=name[:80]))
    return PurePosixPath(TOPS[parts[0]], *parts[1:])


def _has_place(top: str, *inside: str) -> bool:
    """Whether it can be a pupil's program: what shells and Python read by themselves is none, nor what was built."""
    if top == "src" or not inside or inside[0].startswith("."):
        return top == "src" and bool(inside)
    if top == "folder":
        return len(inside) > 1 and inside[0].casefold() != _WORKSPACE
    return top in TOPS and len(inside) == 1


def fits(name: str) -> bool:
    """Whether a file of this name is taken."""
    try:
        return bool(_inside(name))
    except SubmissionRefused:
        return False


def _write(archive: zipfile.ZipFile, info: zipfile.ZipInfo, target: Path, left: int) -> int:
    """Unpack one file of at most `left` bytes, whatever the zip says of its size; returns its size."""
    target.parent.mkdir(parents=True, exist_ok=True)
    size = 0
    with archive.open(info) as source, open(target, "xb") as file:
        while piece := source.read(_PIECE):
            size += len(piece)
            if size > min(left, LARGEST_FILE):
                raise SubmissionRefused(Say("grade.zip.bomb", megabytes=MOST_BYTES // 1_000_000))
            file.write(piece)
    if (info.external_attr >> 16) & stat.S_IXUSR:
        target.chmod(0o755)
    return size


def _manifest(archive: zipfile.ZipFile) -> Submission:
    try:
        info = archive.getinfo(MANIFEST)
    except KeyError:
        raise SubmissionRefused(Say("grade.zip.no_manifest", name=MANIFEST)) from None
    with archive.open(info) as file:
        text = file.read(LARGEST_MANIFEST + 1)
    if len(text) > LARGEST_MANIFEST:
        raise SubmissionRefused(Say("grade.zip.manifest", reason=f"> {LARGEST_MANIFEST} bytes"))
    try:
        data = json.loads(text.decode("utf-8"))
    except (UnicodeDecodeError, json.JSONDecodeError, RecursionError, ValueError) as error:
        raise SubmissionRefused(Say("grade.zip.manifest", reason=str(error)[:80])) from None
    if not isinstance(data, dict) or not isinstance(data.get("version"), int):
        raise SubmissionRefused(Say("grade.zip.manifest", reason="version?"))
    if data["version"] > VERSION:
        raise SubmissionRefused(Say("grade.zip.newer", version=data["version"]))
    return Submission(_text(data.get("pupil")), _text(data.get("home")), _answers(data.get("answers")))


def _answers(value: Any) -> dict[str, dict[str, str]]:
    """By lesson and step, the letters that make sense."""
    found: dict[str, dict[str, str]] = {}
    for lesson, steps in value.items() if isinstance(value, dict) else ():
        if isinstance(steps, dict):
            found[str(lesson)] = {
                str(step): letters
                for step, letters in steps.items()
                if isinstance(letters, str) and _LETTERS.match(letters)
            }
    return found


def _text(value: Any) -> str:
    return value[:200] if isinstance(value, str) else ""


def _translate(old: str, home: Path, paths: list[Path]) -> None:
    """Write our home folder where the pupil's stands in the texts: launch files of beginners hold absolute paths."""
    if not old.startswith("/") or len(old) < 6 or ".." in old.split("/") or not old.isprintable():
        return
    for path in paths:
        if path.suffix in _TEXTS:
            data = path.read_bytes()
            if old.encode() + b"/" in data:
                path.write_bytes(data.replace(old.encode() + b"/", bytes(home) + b"/"))
