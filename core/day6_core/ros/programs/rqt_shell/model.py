"""What the shell of rqt shows: command lines and what they print. With Qt 5 the real one has no other shell than this.

Its own words for it (shell.py): "Simple shell for executing non-interactive finite commands."
"""

from __future__ import annotations

from collections.abc import Callable

from day6_core.ros.programs.rqt_py_common.command_lines import CommandLines

PROMPT = ">>> "
"""qt_gui_py_common, console_text_edit.py"""


NO_DESKTOP = "shell.no_desktop"
"""The remark where commands cannot be run."""


class RqtShell(CommandLines):
    """The model of one shell. The window reads `lines`, `prompt`, `version`, and calls `run` and `interrupt`."""

    def __init__(self) -> None:
        super().__init__()
        self.running = ""
        """The command line that runs; '' for none."""
        self.on_run: Callable[[str], object] | None = None
        """Called (any thread) with a line that is to be run."""
        self.on_interrupt: Callable[[], object] | None = None
        """Called (any thread) to end the command that runs."""

    @property
    def prompt(self) -> str | None:
        return None if self.running else PROMPT

    @property
    def can_interrupt(self) -> bool:
        return bool(self.running)

    def run(self, line: str) -> bool:
        """Run a command line; False while another one runs, or for an empty one."""
        with self._lock:
            if self.running or not line.strip():
                return False
            self.running = line
            self.history.append(line)
            self._show_command(PROMPT + line)
        if self.on_run is not None:
            self.on_run(line)
        return True

    def interrupt(self) -> None:
        """End the command that runs."""
        if self.on_interrupt is not None:
            self.on_interrupt()

    def ended(self) -> None:
        """The command has ended."""
        with self._lock:
            self.running, self._open = "", None
            self.version += 1
