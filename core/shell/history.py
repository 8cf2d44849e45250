"""The lines typed so far, kept in `~/.bash_history` as bash does."""

from __future__ import annotations

from pathlib import Path

from day6_tui.core.whole_file import append_private

KEPT = 1000


class History:
    """`lines`, oldest first; repeated lines and lines that begin with a space are not kept (HISTCONTROL=ignoreboth)."""

    def __init__(self, file: Path) -> None:
        self._file = file
        self.lines: list[str] = []
        try:
            self.lines = file.read_text(encoding="utf-8", errors="surrogateescape").splitlines()[-KEPT:]
        except OSError:
            return  # a first start, or a home that cannot be read: then there is none

    def add(self, source: str) -> None:
        """Remember a command; a command of several lines becomes one where that means the same."""
        line = source if "<<" in source else "; ".join(part for part in source.split("\n") if part.strip())
        if line.startswith(" ") or (self.lines and self.lines[-1] == line):
            return
        self.lines.append(line)
        if len(self.lines) > KEPT:
            del self.lines[0]
        try:
            append_private(self._file, (line.replace("\n", " ") + "\n").encode("utf-8", "surrogateescape"))
        except OSError:
            return  # a full or read-only disk must not make the terminal unusable

    def search(self, text: str, before: int) -> int | None:
        """Index of the last line before index `before` that contains `text`; None if there is none."""
        for index in range(min(before, len(self.lines)) - 1, -1, -1):
            if text in self.lines[index]:
                return index
        return None
