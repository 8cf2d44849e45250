"""What the machine tells a program that looks at all of it: its terminals, what was run in them, its windows, its domains.

`Session.overview`; a command in a real terminal has none. Any method may be called on the scheduler's thread only.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import TYPE_CHECKING, NamedTuple, Protocol

if TYPE_CHECKING:
    from day6_core.session.display import Window


class RunLine(Protocol):
    """A line that was run in a terminal, or still runs: then `status` and `ended_ns` are None. Times are epoch nanoseconds."""

    number: int
    source: str
    cwd: Path
    began_ns: int
    ended_ns: int | None
    status: int | None

    @property
    def output(self) -> str:
        """The end of what was printed meanwhile, with its control sequences."""


class TerminalView(NamedTuple):
    """One terminal as it is now."""

    number: int
    """Counted from 1, the oldest first."""
    cwd: Path
    variables: Mapping[str, str]
    """Those that programs started there get."""
    lines: Sequence[RunLine]
    """What was run, oldest first."""
    running: Sequence[str]
    """The commands that have not ended."""
    version: int
    """Grows with everything that is printed."""


class Overview(Protocol):
    """The whole machine, for looking only."""

    @property
    def home(self) -> Path:
        """The home folder of the user; a drill has one of its own."""

    @property
    def searching(self) -> str:
        """'drill' or 'exam' while the pupil is to find a fault himself, '' otherwise: what names faults is quiet then."""

    def terminals(self) -> list[TerminalView]:
        """Return the open terminals, the oldest first."""

    def windows(self) -> Sequence[Window[object]]:
        """Return the open windows, the oldest first."""

    def command_of(self, pid: int) -> Sequence[str]:
        """Return the words of the command that runs as this process of the machine, none for another. Any thread may ask."""

    def domains(self) -> Mapping[int, Sequence[str]]:
        """Return the domains in use here, each with the full names of its nodes, hidden ones left out."""
