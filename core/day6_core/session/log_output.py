"""The output for log lines of a program's nodes: its standard error, or standard output if its environment says so."""

from __future__ import annotations

from typing import TYPE_CHECKING

from day6_core.session.streams import WriteError

if TYPE_CHECKING:
    from day6_core.session.session import Session


class LogOutput:
    """A separate stream for log lines. A closed terminal and a full disk swallow them, as with rcl's console output."""

    def __init__(self, session: Session) -> None:
        self._session = session
        self._to_stdout = session.env.get("RCUTILS_LOGGING_USE_STDOUT") == "1"

    def write(self, text: str) -> None:
        """Write whole lines at once."""
        stream = self._session.stdout if self._to_stdout else self._session.stderr
        try:
            stream.write(text)
            stream.flush()
        except (BrokenPipeError, WriteError):
            return

    def isatty(self) -> bool:
        """Return whether lines are coloured by their severity."""
        return (self._session.stdout if self._to_stdout else self._session.stderr).isatty()
