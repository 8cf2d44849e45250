"""The window of rqt_shell: a line for a command, above it what the commands before have printed."""

from __future__ import annotations

from typing import TYPE_CHECKING

from day6_tui.windows.parts.command_pane import CommandPane

if TYPE_CHECKING:
    from day6_core.ros.programs.rqt_shell.model import RqtShell  # noqa: F401 - in a base class


class ShellPane(CommandPane["RqtShell"]):
    """While a command runs nothing can be typed."""
