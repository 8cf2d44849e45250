"""Statuses as RViz keeps them: of every display a list `Status: Ok`, whose word and colour are those of the worst line."""

from __future__ import annotations

from day6_tui.core.ros.programs.rviz2.model.properties import STATUS, Property

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

    def put(self, level: int, name: str, text: str) -> bool:
        """Set the line called `name`; True if that changed anything."""
        for line in self.children:
            if line.name == name:
                assert isinstance(line, Status)
                if (line.level, line.value) == (level, text):
                    return False
                line.level, line.value = level, text
                break
        else:
            self.add(Status(name, text, level))
        self._judge()
        return True

    def drop(self, name: str) -> bool:
        """Take a line away; True if it was there."""
        for line in self.children:
            if line.name == name:
                self.remove(line)
                self._judge()
                return True
        return False

    def clear(self) -> None:
        self.children = []
        self._judge()

    def line(self, name: str) -> tuple[str, str] | None:
        """The word and the text of a line: ('Ok', 'Transform OK'); None if there is none."""
        for line in self.children:
            if line.name == name and isinstance(line, Status):
                return WORDS[line.level], str(line.value)
        return None

    def _judge(self) -> None:
        self.level = max((line.level for line in self.children if isinstance(line, Status)), default=OK)
        self.name = f"{self.word}: {WORDS[self.level]}"
