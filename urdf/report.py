"""What urdfdom says about a robot description, line by line, in the words and the order it says them."""

from __future__ import annotations

from dataclasses import dataclass

from day6_tui.urdf.model import Robot


@dataclass(frozen=True, slots=True)
class Diagnostic:
    """One message of the parser; `str()` is what console_bridge writes to stderr (one or two lines, no last newline).

    `source` and `source_line` are the place in urdfdom 4.0.1 that says it (None for messages urdfdom does not have);
    `line` and `column` the place in the description that caused it, 0 where there is none.
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
    """The outcome of a check: the robot (None when urdfdom refuses it) and everything that was said."""

    robot: Robot | None
    diagnostics: tuple[Diagnostic, ...] = ()

    @property
    def text(self) -> str:
        """All messages as they stand on stderr, with the newline at the end; empty when there is none."""
        return "".join(f"{diagnostic}\n" for diagnostic in self.diagnostics)
