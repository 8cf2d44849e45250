"""A file that a teacher hands out: what it may be called, where it goes in a pupil's home, and that it replaces nothing.

On a network it is one message to a pupil's desktop, which answers where it is now, or why it is not there.
"""

from __future__ import annotations

import errno
import json
import os
import unicodedata
from collections.abc import Callable, Iterable, Iterator
from contextlib import suppress
from pathlib import Path
from typing import NamedTuple

from day6_core.classroom.order import LONGEST_PATH
from day6_core.reason import reason
from day6_core.session.harmless import one_line

FOLDER = "handed"
"""In the homes."""
LARGEST = 1 << 20
"""Bytes of a file."""
LONGEST_NAME, LONGEST_ENDING = 100, 20
"""Bytes of a file's name that is made here, and of what stands after its dot."""
MOST_ALIKE = 100
"""Names that are tried beside one that is taken."""
LONGEST_MESSAGE = LARGEST + (4 << 10)
LONGEST_ANSWER = 4 << 10
LONGEST_REASON = 200


class Answer(NamedTuple):
    """Where a file is now in the home, or why it is not there: one of them is ''."""

    path: str = ""
    why: str = ""


def clean_file_name(text: str) -> str:
    """The name under which a file from outside is kept: its last part, of letters that are seen, and no hidden file."""
    last = unicodedata.normalize("NFC", text).replace("\\", "/").rpartition("/")[2]
    seen = "".join(letter for letter in last if letter.isprintable() and letter not in '<>:"|?*').strip(" .-")
    stem, dot, ending = seen.rpartition(".")
    if not stem or len(ending.encode()) > LONGEST_ENDING:
        stem, dot, ending = seen, "", ""
    room = LONGEST_NAME - len(f"{dot}{ending}".encode())
    return f"{stem.encode()[:room].decode(errors='ignore').strip() or 'file'}{dot}{ending}"


def beside(name: str) -> Iterator[str]:
    """The name, and those that are tried where it is taken."""
    yield name
    path = Path(name)
    yield from (f"{path.stem}_{number}{path.suffix}" for number in range(2, MOST_ALIKE))


def put_beside(path: str, names: Iterable[str], write: Callable[[str], object], has: Callable[[str], bool]) -> str:
    """Write under the first of these names that is free, and return it; one that has the same contents already is the one.

    `write` raises FileExistsError where something is. Raises FileExistsError, of `path`, if all are taken; OSError.
    """
    for name in names:
        with suppress(FileExistsError):
            write(name)
            return name
        if has(name):
            return name
    raise FileExistsError(errno.EEXIST, os.strerror(errno.EEXIST), path)


def put(home: Path, name: str, data: bytes) -> str:
    """Put a file into the own home and return where it is; one with the same contents is the one. Raises OSError."""
    folder = home / FOLDER
    folder.mkdir(exist_ok=True)
    found = put_beside(
        name, beside(name), lambda each: _write_new(folder / each, data), lambda each: _has(folder / each, data)
    )
    return f"{FOLDER}/{found}"


def _write_new(path: Path, data: bytes) -> None:
    """Whole or not at all; what is there, also a link to nowhere, stays."""
    file = path.open("xb")
    try:
        with file:
            file.write(data)
    except OSError:
        with suppress(OSError):
            path.unlink()
        raise


def _has(path: Path, data: bytes) -> bool:
    try:
        is_like = path.is_file() and not path.is_symlink() and path.stat().st_size == len(data)
        return is_like and path.read_bytes() == data
    except OSError:
        return False


# -- on a network ------------------------------------------------------------------------------------------------------


def message(name: str, data: bytes) -> bytes:
    """Return a file as it is sent."""
    return json.dumps(clean_file_name(name)).encode() + b"\n" + data


def receive(home: Path, sent: bytes) -> bytes:
    """Put what was sent into the own home, and return the answer as it is sent."""
    try:
        head, newline, data = sent.partition(b"\n")
        name = json.loads(head)
        if not newline or not isinstance(name, str) or len(data) > LARGEST:
            raise ValueError("not a file")
        found = Answer(put(home, clean_file_name(name), data))
    except (OSError, ValueError, RecursionError) as error:
        found = Answer(why=reason(error))
    return json.dumps(found._asdict()).encode()


def read_answer(data: bytes) -> Answer:
    """Read an answer from outside: texts that are harmless on a terminal. Raises ValueError if it isn't one."""
    if len(data) > LONGEST_ANSWER:
        raise ValueError(f"{len(data)} bytes")
    try:
        found = json.loads(data)
        path, why = (one_line(str(found[key])) for key in ("path", "why"))
    except (RecursionError, TypeError, KeyError) as error:
        raise ValueError(str(error)) from None
    if bool(path) == bool(why):
        raise ValueError("a file is there or it is not")
    return Answer(path[:LONGEST_PATH], why[:LONGEST_REASON])
