"""The assertion about the order of output."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from contextlib import contextmanager
from typing import Any

from launch_testing.util.proc_lookup import resolveProcesses

_LINES_AROUND = 2
"""How many lines before and after the last match a failure shows."""
_PIECES_BEFORE, _PIECES_AFTER = 2, 4
"""How many pieces of output around it are searched for these lines."""


class SequentialTextChecker:
    """Asserts that texts follow each other in pieces of output; no text is found across the border of two pieces."""

    def __init__(self, output: Sequence[str]) -> None:
        self._output = output
        self._piece = 0
        self._place = 0
        """Where the last match ended."""

    def assertInText(self, msg: str) -> None:
        self.assertInStdout(msg)

    def assertInStdout(self, msg: str) -> None:
        """Assert that a text comes after the last one; the search for the next one begins behind it."""
        for number in range(self._piece, len(self._output)):
            found = self._output[number].find(msg, self._place if number == self._piece else 0)
            if found != -1:
                self._piece, self._place = number, found + len(msg)
                return
        raise AssertionError(
            f"'{msg}' not found in sequence after previous match.  "
            f"The output near the last matched line:\n{self.get_nearby_lines()}"
        )

    def get_nearby_lines(self) -> str:
        """Return the line of the last match, with two lines before and after it."""
        first = max(0, self._piece - _PIECES_BEFORE)
        text = "".join(self._output[first : self._piece + _PIECES_AFTER])
        here = self._place + sum(map(len, self._output[first : self._piece]))
        before, rest = text[:here].split("\n"), text[here:]
        after = rest.split("\n")[
            : _LINES_AROUND + 1 + rest.startswith("\n")
        ]  # at the end of a line the next one is meant
        return ("\n".join(before[-_LINES_AROUND - 1 :]) + "\n".join(after)).removesuffix("\n")


@contextmanager
def assertSequentialStdout(proc_output: Any, process: Any, cmd_args: Any = None) -> Iterator[SequentialTextChecker]:
    """Give a checker of the order of a process's output. It must be one process, see `resolveProcesses`."""
    found = resolveProcesses(proc_output, process=process, cmd_args=cmd_args, strict_proc_matching=True)[0]
    yield SequentialTextChecker([io.text.decode(errors="replace") for io in proc_output[found]])
