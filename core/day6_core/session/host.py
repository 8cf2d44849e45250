"""The shell that started a program and outlives it, as far as the program may use it."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING, Protocol

if TYPE_CHECKING:
    from day6_core.session.program import Program
    from day6_core.session.session import Main, Session
    from day6_core.session.streams import InputStream, OutputStream


class Host(Protocol):
    """`Session.host`; a command in a real terminal has none."""

    @property
    def starts_programs(self) -> bool:
        """Whether `start_beside` and `command` can be used."""

    async def run_line(self, source: str, session: Session) -> int:
        """Run command lines on the program's streams; returns their status."""

    def command(self, name: str) -> Main | None:
        """Return the machine's own command of that name, None if it has no such command."""

    def becomes(self, session: Session, before: list[str]) -> None:
        """Note that a program goes on as another one (`Session.execute`); `before` was its `argv`."""

    @property
    def terminals(self) -> tuple[str, ...]:
        """Names of the commands that open a terminal of the machine."""

    def start_beside(
        self,
        argv: list[str],
        main: Main,
        stdout: OutputStream,
        stderr: OutputStream,
        *,
        env: dict[str, str],
        cwd: Path,
        stdin: InputStream | None = None,
    ) -> Program:
        """Start another program in the background; without `stdin` it has nothing to read.

        Raises:
            OSError: too many programs are running.
        """
