"""One text file that is being edited: read and written whole, never half, with a copy of what is not saved yet.

The copy lies in the user's state folder, not beside the file: a workspace stays as it is. It survives a crash of
day6-tui, a closed window and a full disk, and is offered when the file is opened again.
"""

from __future__ import annotations

import contextlib
import hashlib
import json
import os
from pathlib import Path
from typing import NamedTuple

from day6_tui.core.whole_file import replace_file, write_private

LARGEST = 4_000_000
"""Bytes of the largest file that is opened: more is no program, and an editor in a terminal would crawl."""


class CannotEdit(Exception):
    """The file cannot be opened; the text says why."""


class Stamp(NamedTuple):
    """What changes when somebody else writes a file: time in nanoseconds and size in bytes; None where there is none."""

    time: int
    size: int


class TextFile:
    """A file on the disk, which need not exist yet. `state` is the folder for copies of unsaved texts."""

    def __init__(self, path: Path, state: Path) -> None:
        self.path = path
        self._copy = state / (hashlib.sha256(os.fsencode(os.path.abspath(path))).hexdigest()[:24] + ".json")
        self._newline = "\n"
        self._stamp: Stamp | None = None

    def read(self) -> str:
        """Return the text with "\\n" as line end; '' for a file that is not there yet. Raises CannotEdit."""
        try:
            if not self.path.exists():
                self._stamp = None
                return ""
            if self.path.is_dir():
                raise CannotEdit(f"{self.path} is a directory")
            if self.path.stat().st_size > LARGEST:
                raise CannotEdit(f"{self.path}: larger than {LARGEST // 1_000_000} MB")
            data = self.path.read_bytes()
        except OSError as error:
            raise CannotEdit(f"{self.path}: {error.strerror or error}") from None
        try:
            text = data.decode("utf-8-sig")
        except UnicodeDecodeError as error:
            raise CannotEdit(f"{self.path}: not UTF-8 text (byte {error.start})") from None
        self._stamp = self._look()
        self._newline = "\r\n" if "\r\n" in text else "\n"
        return text.replace("\r\n", "\n")

    def write(self, text: str) -> None:
        """Replace the file by `text`: either whole, or the old one stays. Raises OSError."""
        target = Path(os.path.realpath(self.path))
        target.parent.mkdir(parents=True, exist_ok=True)
        replace_file(target, text.replace("\n", self._newline).encode("utf-8"))
        self._stamp = self._look()
        self.forget()

    def changed_outside(self) -> bool:
        """Say whether somebody else wrote, made or deleted the file since it was read or written here."""
        return self._look() != self._stamp

    # -- the copy of what is not saved ---------------------------------------------------------------------------------

    def keep(self, text: str) -> None:
        """Keep a copy of an unsaved text. Raises OSError."""
        write_private(self._copy, json.dumps({"path": str(self.path), "text": text}).encode("utf-8"))

    def kept(self) -> str | None:
        """Return the unsaved text of an earlier time, None if there is none."""
        try:
            found = json.loads(self._copy.read_text(encoding="utf-8"))
            return str(found["text"])
        except (OSError, ValueError, KeyError, TypeError):
            return None  # none, or one that was cut short: it is only a second copy

    def forget(self) -> None:
        """Delete the copy."""
        with contextlib.suppress(OSError):
            self._copy.unlink(missing_ok=True)

    def _look(self) -> Stamp | None:
        try:
            found = self.path.stat()
        except OSError:
            return None
        return Stamp(found.st_mtime_ns, found.st_size)
