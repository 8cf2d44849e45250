"""The model of an editor window: one file at a time of one folder. The window owns the text, this module the files."""

from __future__ import annotations

import os
from collections import deque
from collections.abc import Iterator, Mapping
from pathlib import Path

from day6_core.shell.editing.checks import Problem, check, language_of
from day6_core.shell.editing.copies import Copy, Holder
from day6_core.shell.editing.file import CannotEdit, TextFile
from day6_core.shell.outside import is_outside

_SKIPPED = {"build", "install", "log", "__pycache__", "node_modules"}
MOST_FILES = 500
"""Most files of a folder that are offered; a larger folder is not a lesson's workspace."""


class Editor:
    """The model of an editor window.

    `folder` is what `code .` was given, else the folder of the file. `file` is None until one is chosen. `saved` is the text
    on the disk as it was last read or written here; `text` what the window begins with.
    """

    def __init__(
        self, folder: Path, state: Path, name: str, home: Path | None = None, variables: Mapping[str, str] | None = None
    ) -> None:
        self.folder = folder
        self.name = name
        self.file: TextFile | None = None
        self.saved = ""
        self.text = ""
        self.recovered = False
        """Whether `text` is the unsaved text of an earlier session."""
        self.left: list[Copy] = []
        """Further unsaved texts of this file, of editors that are gone; the last one first."""
        self.version = 0
        """Incremented when another file is opened."""
        self.home = home
        """The folder that holds the lesson's files; None if every file counts as one."""
        self._variables = variables or {}
        """Those of the terminal that runs it: they say which packages there are."""
        self._state = state
        self._typed: deque[str] = deque()

    # -- the terminal it was started in --------------------------------------------------------------------------------

    def keys(self, text: str) -> None:
        """Take what is typed in the terminal in which nano runs, even before its window is open (any thread)."""
        self._typed.append(text)

    def resize(self, columns: int, rows: int) -> None:
        """Nothing to do: the window does not depend on the size of that terminal."""

    def wants_signal_keys(self) -> bool:
        """Return False: to a terminal editor, Ctrl-C and Ctrl-Z are keys like any other."""
        return False

    def take_typed(self) -> str:
        """Return the keys typed there since the last call."""
        typed = []
        while self._typed:
            typed.append(self._typed.popleft())
        return "".join(typed)

    # -- files ---------------------------------------------------------------------------------------------------------

    def open(self, path: Path) -> None:
        """Show another file. Raises CannotEdit and then shows what it showed before."""
        file = TextFile(path, self._state, self.name)
        saved = file.read()
        self.close()
        file.copies.hold()
        self.file, self.saved = file, saved
        self.text, self.recovered, self.left = saved, False, []
        for copy in file.copies.left():
            if copy.text == saved:
                file.copies.drop(copy)
            elif self.recovered:
                self.left.append(copy)
            else:
                self._take(copy)
        self.version += 1

    def choose(self, copy: Copy) -> None:
        """Show another of the unsaved texts; the rest is offered again the next time."""
        if self._take(copy):
            self.left = []
            self.version += 1

    def _take(self, copy: Copy) -> bool:
        """Make an unsaved text that was left the one of this window; return False if another editor was faster."""
        assert self.file is not None
        if not self.file.copies.take(copy):
            return False
        self.file.form, self.text, self.recovered = copy.form, copy.text, True
        return True

    def others(self) -> list[Holder]:
        """Return the other editors that have the file open."""
        return [] if self.file is None else self.file.copies.others()

    def close(self) -> None:
        """The window is closed; what it kept is offered when the file is opened again."""
        if self.file is not None:
            self.file.copies.release()

    def is_outside(self, path: Path) -> bool:
        """Whether `path` is outside the folder of the lesson's files, where a change has to be confirmed."""
        return self.home is not None and is_outside(path, self.home)

    def save(self, text: str) -> None:
        """Write the text. Raises OSError."""
        assert self.file is not None
        self.file.write(text)
        self.saved = self.text = text
        self.recovered = False

    def save_as(self, path: Path, text: str) -> None:
        """Write the text to another file and go on with that one. Raises OSError and then nothing has changed."""
        file = TextFile(path, self._state, self.name)
        if self.file is not None:
            file.form = self.file.form
        file.write(text)
        if self.file is not None:
            self.file.copies.forget()
            self.close()
        file.copies.hold()
        self.file, self.saved, self.text, self.recovered, self.left = file, text, text, False, []
        self.version += 1

    def keep(self, text: str) -> None:
        """Keep an unsaved text in case it is never saved. Raises OSError."""
        if self.file is not None:
            if text == self.saved:
                self.file.copies.forget()
            else:
                self.file.keep(text)

    def reload(self) -> str:
        """Return the text as somebody else has written it. Raises CannotEdit."""
        assert self.file is not None
        self.saved = self.text = self.file.read()
        self.recovered = False
        return self.saved

    def changed_outside(self) -> bool:
        """Whether the file on the disk is not the one that was read."""
        return self.file is not None and self.file.changed_outside()

    def exists(self) -> bool:
        """Whether the file exists on the disk."""
        return self.file is not None and self.file.path.exists()

    def check(self, text: str) -> Problem | None:
        """Return the first thing that is wrong in the text."""
        return None if self.file is None else check(self.file.path, text)

    def completions(self, text: str, row: int, column: int) -> tuple[list[str], int]:
        """Return what Tab offers at a place of the text, and the column where the word that is being typed begins."""
        if self.file is None or language_of(self.file.path) != "python":
            return [], column
        from day6_core.shell.editing.completion import completions

        return completions(text, row, column, self._variables, self.file.path.parent)

    def title(self) -> str:
        """The file name to show."""
        if self.file is None:
            return self.folder.name
        try:
            return self.file.path.relative_to(self.folder).as_posix()
        except ValueError:
            return self.file.path.name

    def files(self) -> list[Path]:
        """Return the files of the folder that a person would edit, at most MOST_FILES."""
        found = []
        for path in _walk(self.folder):
            found.append(path)
            if len(found) == MOST_FILES:
                break
        return sorted(found)


def _walk(folder: Path) -> Iterator[Path]:
    for here, folders, names in os.walk(folder):
        folders[:] = sorted(name for name in folders if name not in _SKIPPED and not name.startswith("."))
        for name in sorted(names):
            if not name.startswith(".") and not name.endswith((".pyc", ".png", ".stl", ".dae", ".mcap", ".db3")):
                yield Path(here, name)


__all__ = ["CannotEdit", "Editor"]
