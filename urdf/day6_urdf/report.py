"""urdfdom's messages about a robot description, word for word and in its order."""

from __future__ import annotations

from dataclasses import dataclass

from day6_urdf.model import Robot


@dataclass(frozen=True, slots=True)
class Diagnostic:
    """One message of the parser; `str()` is the text console_bridge writes to stderr (one or two lines, no final newline).

    `source` and `source_line` are the place of the message in urdfdom 4.0.1 (None for messages urdfdom does not have); `line`
    and `column` are the place in the description that caused it, from 1, 0 if there is none.
    """

    level: str
    text: str
    source: str | None = None
    source_line: int = 0
    line: int = 0
    column: int = 0

    def __str__(self) -> str:
        first = f"{self.level + ':':<9}{self.text}"
        if self.source is None:
            return first
        return f"{first}\n         at line {self.source_line} in ./urdf_parser/src/{self.source}.cpp"


@dataclass(frozen=True, slots=True)
class Report:
    """The result of a check: the robot (None if urdfdom refuses it) and all messages."""

    robot: Robot | None
    diagnostics: tuple[Diagnostic, ...] = ()

    @property
    def text(self) -> str:
        """All messages as on stderr, with a final newline; empty if there are none."""
        return "".join(f"{diagnostic}\n" for diagnostic in self.diagnostics)
