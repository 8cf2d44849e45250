"""Copies of a text that is not saved yet: each editor has one of its own, and a lock that tells others that it is still open.

Both lie in the user's state folder, named after the file, the program and its process. The system releases the lock when the
process dies, however it dies: a copy that nobody holds is of an editor that is gone, and is offered to the next one.
"""

from __future__ import annotations

import contextlib
import hashlib
import json
import os
import weakref
from collections.abc import Iterator
from pathlib import Path
from typing import NamedTuple

from day6_core.link.file_lock import FileLock
from day6_core.session.folder import working_folder
from day6_core.whole_file import make_private_folder, write_private

_LOCK, _TEXT = ".lock", ".json"

MOST_TRIES = 100
"""Tries to take one's own lock, which others who look whether its editor lives have for a moment."""


class Form(NamedTuple):
    """The part of a file's bytes that is not in its text: the byte order mark, and the line ending."""

    mark: str = ""
    newline: str = "\n"


class Copy(NamedTuple):
    """A text that an editor had not saved when it died."""

    name: str
    time: float
    """When it was written, in seconds since 1970."""
    form: Form
    text: str


class Holder(NamedTuple):
    """An editor that has the file open."""

    program: str
    process: int


class Copies:
    """The copies of one file: that of this editor, those of editors that are gone, and which others are open."""

    def __init__(self, path: Path, folder: Path, program: str) -> None:
        whole = working_folder() / path
        self._folder = folder
        self._stem = _stem(os.path.realpath(whole))
        self._older = _stem(os.path.normpath(whole)) + _TEXT
        """What the only copy of a file was called until 0.1."""
        self._program = program
        self._name = ""
        self._lock: FileLock | None = None
        self._end: weakref.finalize[[Path, FileLock], Copies] | None = None

    # -- this editor's -------------------------------------------------------------------------------------------------

    def hold(self) -> None:
        """Let other editors see that this one has the file open. Where nothing can be written, they don't."""
        self._name = self._name or f"{self._stem}-{self._program}-{os.getpid()}-{os.urandom(4).hex()}"
        with contextlib.suppress(OSError):
            make_private_folder(self._folder)
        for _ in range(MOST_TRIES):
            if self._holds(self._name):
                break

    def keep(self, form: Form, text: str) -> None:
        """Write the copy. Raises OSError."""
        if self._lock is None or not self._lock.held:
            self.hold()
        data = {"text": text, **form._asdict()}
        write_private(self._folder / (self._name + _TEXT), json.dumps(data).encode())

    def forget(self) -> None:
        """Delete the copy of this editor."""
        if self._name:
            _unlink(self._folder / (self._name + _TEXT))

    def release(self) -> None:
        """This editor is closed: if there is a copy of its text, the next one is offered it."""
        if self._end is not None:
            self._end()
        self._name, self._lock, self._end = "", None, None

    # -- those of others -----------------------------------------------------------------------------------------------

    def left(self) -> list[Copy]:
        """Return the texts of editors that are gone, the last one first."""
        found = []
        for path in self._files(_TEXT):
            if path.stem != self._name and not _is_held(path.with_suffix(_LOCK)):
                copy = _read(path)
                found += [copy] if copy is not None else []
        return sorted(found, key=lambda copy: copy.time, reverse=True)

    def take(self, copy: Copy) -> bool:
        """Make a copy that was left this editor's own; return False if another one was faster."""
        self.release()
        taken = self._holds(copy.name) and (self._folder / (copy.name + _TEXT)).exists()
        if taken:
            self._name = copy.name
        else:
            self.release()
            self.hold()
        return taken

    def drop(self, copy: Copy) -> None:
        """Delete a copy that was left: its text is in the file."""
        _unlink(self._folder / (copy.name + _TEXT))

    def others(self) -> list[Holder]:
        """Return the other editors that have the file open."""
        living = [path.stem for path in self._files(_LOCK) if path.stem != self._name and _is_held(path)]
        return sorted(holder for name in living if (holder := _holder(name)) is not None)

    def _files(self, suffix: str) -> Iterator[Path]:
        try:
            names = os.listdir(self._folder)
        except OSError:
            return
        for name in names:
            if name.endswith(suffix) and (name.startswith(f"{self._stem}-") or name == self._older):
                yield self._folder / name

    def _holds(self, name: str) -> bool:
        """Take the lock of a copy; return False if somebody else has it."""
        path = self._folder / (name + _LOCK)
        lock = FileLock(path)
        if not _is_free(lock):
            return False
        if lock.held and not _is_at(path, lock.fileno()):  # somebody deleted it between opening and locking
            lock.release()
            return False
        self._lock = lock
        self._end = weakref.finalize(self, _let_go, path, lock)
        return True


def _stem(path: str) -> str:
    return hashlib.sha256(os.fsencode(path)).hexdigest()[:24]


def _is_free(lock: FileLock) -> bool:
    """Take a lock unless its holder lives; where nothing can be locked, nobody is known to live."""
    try:
        return lock.try_acquire()
    except OSError:
        return True


def _is_held(path: Path) -> bool:
    """Return whether the editor of a lock lives; the file of one that is gone is deleted."""
    lock = FileLock(path)
    if not path.exists():
        return False
    if not _is_free(lock):
        return True
    _let_go(path, lock)
    return False


def _is_at(path: Path, descriptor: int) -> bool:
    try:
        return os.path.samestat(os.stat(path), os.fstat(descriptor))
    except OSError:
        return False


def _let_go(path: Path, lock: FileLock) -> None:
    if os.name == "nt":  # where an open file cannot be deleted
        lock.release()
    _unlink(path)
    lock.release()


def _unlink(path: Path) -> None:
    with contextlib.suppress(OSError):
        path.unlink(missing_ok=True)


def _holder(name: str) -> Holder | None:
    program, _, process = name.partition("-")[2].rpartition("-")[0].rpartition("-")
    return Holder(program, int(process)) if process.isdecimal() else None


def _read(path: Path) -> Copy | None:
    """Return a copy, None if it is missing or truncated: it is only a second one."""
    try:
        found = json.loads(path.read_text(encoding="utf-8"))
        form = Form(*(str(found.get(name, had)) for name, had in Form()._asdict().items()))
        return Copy(path.stem, path.stat().st_mtime, form, str(found["text"]))
    except (OSError, ValueError, KeyError, TypeError, AttributeError):
        return None


__all__ = ["Copies", "Copy", "Form", "Holder"]
