"""Random sessions of an editor: edits, saves, others who write, full disks, ends without warning, openings.

At each end every text that was saved (or that somebody else wrote since) is on the disk whole, and every unsaved text is in the
window, in the kept copy, or the user was told that it is not.
"""

from __future__ import annotations

import errno
import os
import random
import sys
from pathlib import Path

import pytest

from day6_core.shell.editing.file import CannotEdit, put_together
from day6_core.shell.editing.model import Editor

PIECES = ["a", "轮", "\n", "\r", "\r\n", "\f", "\u2028", "\ufeff", "\0", "x = 1\n", "\t", "\x85"]


class Session:
    """One person, one file, and a disk that may be full; `expected` is what the file must hold."""

    def __init__(self, folder: Path, seed: int, monkeypatch: pytest.MonkeyPatch) -> None:
        self.rng = random.Random(seed)
        self.folder = folder
        self.path = folder / "work.txt"
        self.names = [self.path]
        self.expected: bytes | None = None
        self.full = False
        real = os.write

        def fsync(number: int) -> None:
            if self.full:
                raise OSError(errno.ENOSPC, "No space left on device")

        def write(number: int, data: bytes) -> int:
            if self.full:
                raise OSError(errno.ENOSPC, "No space left on device")
            return real(number, data)

        monkeypatch.setattr(os, "fsync", fsync)
        monkeypatch.setattr(os, "write", write)
        self.open()

    def open(self) -> None:
        self.editor = Editor(self.folder, self.folder / "state", "nano")
        self.editor.open(self.path)
        self.text = self.editor.text
        self.safe = self.text
        """The text that must come back after an end without warning."""

    def whole(self, text: str) -> str:
        """The text as it is in the file; a typed mark or line end is one of the file at the next opening."""
        assert self.editor.file is not None
        return put_together(self.editor.file.form, text)

    def edit(self) -> None:
        at = self.rng.randint(0, len(self.text))
        piece = self.rng.choice(PIECES)
        self.text = self.text[:at] + piece + self.text[at + self.rng.choice([0, 0, 1, 5]) :]

    def keep(self) -> None:
        """The second after the last key."""
        try:
            self.editor.keep(self.text)
        except OSError:
            return  # the window says so: what was kept before is all there is
        self.safe = self.text

    def save(self) -> None:
        if self.editor.changed_outside():
            return  # it asks first
        try:
            self.editor.save(self.text)
        except OSError:
            return  # it says so
        file = self.editor.file
        assert file is not None
        self.expected = (file.form.mark + self.text.replace("\n", file.form.newline)).encode()
        self.safe = self.text

    def somebody_writes(self) -> None:
        if self.full or self.editor.text != self.text:
            return
        self.expected = "".join(self.rng.choices(PIECES, k=6)).encode() + b"%d" % self.rng.randint(0, 10**9)
        self.path.write_bytes(self.expected)
        if self.text == self.editor.saved:
            self.text = self.editor.reload()
            self.safe = self.text
            self.editor.keep(self.text)

    def link(self) -> None:
        if self.path.exists() and len(self.names) == 1 and sys.platform != "win32":
            self.names.append(self.folder / "other name")
            os.link(self.path, self.names[1])

    def is_killed(self) -> None:
        before = [self.whole(text) for text in (self.safe, self.text)]
        self.editor.close()  # as the system does with what a process held
        self.open()
        copies = {path.name: path.read_bytes() for path in (self.folder / "state").iterdir()}
        assert self.whole(self.text) in before, f"the text that was kept or saved last comes back: {copies}"

    def disk(self) -> None:
        self.full = not self.full

    def check(self) -> None:
        for name in self.names:
            assert (name.read_bytes() if name.exists() else None) == self.expected
        assert not list(self.folder.rglob(".day6-*"))


@pytest.mark.parametrize("seed", range(60))
def test_nothing_is_lost_without_a_word(tmp_path: Path, seed: int, monkeypatch: pytest.MonkeyPatch) -> None:
    try:
        session = Session(tmp_path, seed, monkeypatch)
        acts = [session.edit] * 6 + [session.keep] * 3 + [session.save] * 3
        acts += [session.somebody_writes, session.is_killed, session.disk, session.link]
        for _ in range(60):
            session.rng.choice(acts)()
            session.check()
    except CannotEdit as error:
        pytest.fail(f"seed {seed}: {error}")
