"""One text file being edited: read and written completely or not at all, with a copy of what is not saved yet.

The copy (`copies.py`) lies in the user's state folder, not beside the file: a workspace stays as it is. It survives a crash of
day6-tui, a closed window and a full disk, and is offered when the file is opened again.
"""

from __future__ import annotations

import errno
import os
from pathlib import Path
from typing import NamedTuple

from day6_core.reason import reason
from day6_core.shell.editing.copies import Copies, Form
from day6_core.whole_file import must_stay, overwrite_file, replace_file

LARGEST = 4_000_000
"""Bytes of the largest file that is opened: a larger one is not source code, and would slow the editor to a crawl."""


class CannotEdit(Exception):
    """The file cannot be opened; the text says why."""


class Stamp(NamedTuple):
    """What changes when another program writes a file: time in nanoseconds and size in bytes; None if there is no file."""

    time: int
    size: int


MARK = "\ufeff"
"""The byte order mark with which some Windows programs begin a UTF-8 file."""


def taken_apart(whole: str) -> tuple[Form, str]:
    """Return the form and the text of a file; `put_together` of them is the file again, whatever it holds.

    Windows line endings are recognised only if every line has one; in a mixed file "\\r" is a character, as in nano.
    """
    mark = MARK if whole.startswith(MARK) else ""
    text = whole[len(mark) :]
    ends = text.count("\n")
    if ends and text.count("\r\n") == ends:
        return Form(mark, "\r\n"), text.replace("\r\n", "\n")
    return Form(mark), text


def put_together(form: Form, text: str) -> str:
    """Return the bytes of the file."""
    return form.mark + text.replace("\n", form.newline)


class TextFile:
    """A file on the disk, which need not exist yet. `state` is the folder for copies of unsaved texts."""

    def __init__(self, path: Path, state: Path, program: str = "editor") -> None:
        self.path = path
        self.copies = Copies(path, state, program)
        self.form = Form()
        self._stamp: Stamp | None = None

    def read(self) -> str:
        """Return the text with "\\n" as line end (see `taken_apart`); '' for a file that is not there yet. Raises CannotEdit."""
        try:
            if not self.path.exists():
                self._stamp, self.form = None, Form()
                return ""
            if self.path.is_dir():
                raise CannotEdit(f"{self.path} is a directory")
            if self.path.stat().st_size > LARGEST:
                raise CannotEdit(f"{self.path}: larger than {LARGEST // 1_000_000} MB")
            stamp = self._look()  # before reading: anything written meanwhile is a change
            data = self.path.read_bytes()
        except OSError as error:
            raise CannotEdit(f"{self.path}: {reason(error)}") from None
        try:
            text = data.decode("utf-8")
        except UnicodeDecodeError as error:
            raise CannotEdit(f"{self.path}: not UTF-8 text (byte {error.start})") from None
        self._stamp = stamp
        self.form, text = taken_apart(text)
        return text

    def write(self, text: str) -> None:
        """Write `text` completely, or leave the old file as it was. Raises OSError.

        As in nano the file keeps its inode, and with it hard links, permissions and owner. It is overwritten only once a
        copy of the text is on the disk; otherwise it is replaced.
        """
        target = Path(os.path.realpath(self.path))
        data = put_together(self.form, text).encode("utf-8")
        if target.is_file() and not os.access(target, os.W_OK):  # replacing it would be a way round
            raise PermissionError(errno.EACCES, os.strerror(errno.EACCES), str(target))
        if must_stay(target):
            self.keep(text)
            overwrite_file(target, data)
        else:
            target.parent.mkdir(parents=True, exist_ok=True)
            replace_file(target, data)
        self._stamp = self._look()
        self.copies.forget()

    def changed_outside(self) -> bool:
        """Whether another program wrote, created or deleted the file since it was read or written here."""
        return self._look() != self._stamp

    def keep(self, text: str) -> None:
        """Keep a copy of an unsaved text. Raises OSError."""
        self.copies.keep(self.form, text)

    def _look(self) -> Stamp | None:
        try:
            found = self.path.stat()
        except OSError:
            return None
        return Stamp(found.st_mtime_ns, found.st_size)
