"""A screen that is shown to many: each gets the lines that have changed since it got some last, however slow it is."""

from __future__ import annotations

import json

from day6_core.classroom.note import PupilScreen


class Picture:
    """The screen as it is now, and in which version each line came. The same answer is made once for all."""

    def __init__(self) -> None:
        self.version = 0
        self._size = (0, 0)
        self._lines: list[tuple[str, int]] = []
        self._made: dict[int, str] = {}

    def take(self, screen: PupilScreen) -> bool:
        """Here is a screen; returns whether it is another one."""
        size, lines = (screen.columns, screen.rows), screen.ansi.split("\n")[: screen.rows]
        lines += [""] * (screen.rows - len(lines))
        old = self._lines if size == self._size else []
        if old and lines == [line for line, _ in old]:
            return False
        self.version += 1
        self._size, self._made = size, {}
        self._lines = [
            old[row] if row < len(old) and old[row][0] == line else (line, self.version)
            for row, line in enumerate(lines)
        ]
        return True

    def since(self, version: int) -> str:
        """What somebody has to be told who has seen this version; 0: nothing yet."""
        if version not in self._made:
            columns, rows = self._size
            lines = {row: line for row, (line, came) in enumerate(self._lines) if came > version}
            found = {"t": "screen", "columns": columns, "rows": rows, "lines": lines}
            self._made[version] = json.dumps(found, ensure_ascii=False)
        return self._made[version]
