"""The last lines that were run in the terminals, with what they printed as text."""

from __future__ import annotations

from collections.abc import Iterator
from functools import lru_cache
from typing import NamedTuple

from day6_core.ros.programs.day6_inspector.facts import Facts
from day6_core.session.overview import RunLine, TerminalView
from day6_core.session.plain import without_sequences

LAST_LINES = 3
"""Lines of a terminal that are still of interest."""

OLD_NS = 600_000_000_000
LONGEST = 12_000
"""Characters of an output that are searched: its end."""

LONGEST_SOURCE = 60


class LineOutput(NamedTuple):
    """One line that was run, with what it printed as text."""

    terminal: TerminalView
    line: RunLine
    text: str

    @property
    def source(self) -> str:
        """The line as it was typed, shortened."""
        return shortened(self.line.source)

    @property
    def running(self) -> bool:
        return self.line.status is None


def shortened(source: str) -> str:
    """Return a command line that fits into a sentence."""
    source = " ".join(source.split())
    return source if len(source) <= LONGEST_SOURCE else source[: LONGEST_SOURCE - 1] + "…"


def outputs(facts: Facts) -> Iterator[LineOutput]:
    """Yield the lines that are still of interest, the newest of each terminal first.

    The same line again takes the place of the older one, and one that went well that of its failed attempts.
    """
    for terminal in facts.terminals or ():
        seen: set[str] = set()
        for line in list(terminal.lines)[: -LAST_LINES - 1 : -1]:
            ended = line.ended_ns
            source = " ".join(line.source.split())
            attempt = _command(source)
            if source in seen or attempt in seen or (ended is not None and facts.now_ns - ended > OLD_NS):
                continue
            seen.add(source)
            if attempt and line.status == 0:
                seen.add(attempt)
            yield LineOutput(terminal, line, plain(line.output[-LONGEST:]))


def _command(source: str) -> str:
    """Return what a command is for, without what it is given ('ros2 param set …'): '' for one that starts a program."""
    words = source.split()
    return (
        f"{' '.join(words[:3])} …"
        if len(words) > 3 and words[0] == "ros2" and words[1] not in ("run", "launch")
        else ""
    )


@lru_cache(maxsize=32)
def plain(text: str) -> str:
    """Return what a terminal was given without its control sequences."""
    return without_sequences(text).replace("\r", "")
