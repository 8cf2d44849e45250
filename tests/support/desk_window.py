"""A desk, without a screen, on which a command of its shell opens a window."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path
from typing import Any

from day6_core.session.streams import InputStream, OutputStream
from day6_core.shell.desk import Desk
from day6_core.shell.language.redirection import Streams
from day6_core.shell.language.subshells import subshell_main
from tests.support.waiting import until


class DeskWindow:
    """Runs `command`, and has the `model` of the window that it opens; `linked` with other processes, or alone."""

    def __init__(self, home: Path, command: str, *, linked: bool = False) -> None:
        self.desk = Desk(home, join_link=linked)
        if linked:
            self.desk.open_link()
        shell = self.desk.shell(cwd=home)
        streams = Streams(InputStream(), OutputStream(), OutputStream())
        main = subshell_main(shell, lambda: shell.run(f"{command}\n", streams))
        self.program = self.desk.start_program(["bash"], main, streams, env=shell.environment, cwd=home, shell=shell)
        assert self.desk.display is not None
        self.display = self.desk.display
        self.wait(lambda: self.display.windows)
        self.model: Any = self.display.windows[0].model

    def wait(self, condition: Callable[[], object]) -> None:
        """Let the desk go on until something is so."""
        until(
            lambda: self.desk.scheduler.run(lambda: bool(condition()), 0.01),
            every=0.0,
            told=lambda: [getattr(window.model, "lines", None) for window in self.display.windows],
        )

    def close(self) -> None:
        self.desk.hurry()
        self.desk.close()
