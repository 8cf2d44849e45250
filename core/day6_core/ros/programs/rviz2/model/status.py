"""Statuses as RViz keeps them: of every display a list `Status: Ok`, whose word and colour are those of the worst line."""

from __future__ import annotations

from day6_core.ros.programs.rviz2.model.properties import STATUS, Property

OK, WARN, ERROR = 0, 1, 2
WORDS = ("Ok", "Warn", "Error")
COLOURS: tuple[tuple[int, int, int] | None, ...] = (None, (192, 128, 0), (192, 32, 32))
"""Of the names in the panel (rviz_common/properties/status_property.cpp); an Ok has the text's own colour."""


class Status(Property):
    """One line: a name, a text, a level."""

    def __init__(self, name: str, text: str, level: int) -> None:
        super().__init__(name, STATUS, text, read_only=True, saved=False)
        self.level = level


class StatusList(Status):
    """The lines of one display, or of RViz itself. `word` is what stands before the colon."""

    def __init__(self, word: str) -> None:
        super().__init__(f"{word}: {WORDS[OK]}", "", OK)
        self.word = word
        self.value = None
        self._lines: dict[str, Status] = {}

    def put(self, level: int, name: str, text: str) -> bool:
        """Set the line called `name`; True if that changed anything."""
        line = self._lines.get(name)
        if line is None:
            line = self._lines[name] = Status(name, text, level)
            self.add(line)
        elif (line.level, line.value) == (level, text):
            return False
        else:
            line.level, line.value = level, text
        if level > self.level:
            self._set_level(level)
        elif level < self.level:
            self._judge()
        return True

    def drop(self, name: str) -> bool:
        """Take a line away; True if it was there."""
        line = self._lines.pop(name, None)
        if line is None:
            return False
        self.remove(line)
        self._judge()
        return True

    def clear(self) -> None:
        self.children = []
        self._lines = {}
        self._judge()

    def line(self, name: str) -> tuple[str, str] | None:
        """The word and the text of a line: ('Ok', 'Transform OK'); None if there is none."""
        line = self._lines.get(name)
        return None if line is None else (WORDS[line.level], str(line.value))

    @property
    def lines(self) -> list[Status]:
        """The lines, in the order in which they came."""
        return list(self._lines.values())

    def _judge(self) -> None:
        self._set_level(max((line.level for line in self._lines.values()), default=OK))

    def _set_level(self, level: int) -> None:
        self.level = level
        self.name = f"{self.word}: {WORDS[self.level]}"
