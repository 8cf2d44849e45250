"""The whole machine as a program that looks on sees it (`day6_core/session/overview`)."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import TYPE_CHECKING

from day6_core.facts.graph import nodes_by_domain
from day6_core.session.overview import TerminalView

if TYPE_CHECKING:
    from day6_core.session.display import Window
    from day6_core.shell.desk import Desk


class DeskOverview:
    """Looks at a desk."""

    def __init__(self, desk: Desk) -> None:
        self._desk = desk

    @property
    def home(self) -> Path:
        return self._desk.login_home

    @property
    def searching(self) -> str:
        return self._desk.searching()

    def terminals(self) -> list[TerminalView]:
        """Return the open terminals, without those whose shell has ended."""
        return [
            TerminalView(
                number,
                terminal.shell.cwd,
                terminal.shell.environment,
                terminal.runs.all,
                terminal.running,
                terminal.version,
            )
            for number, terminal in enumerate(list(self._desk.terminals), 1)
            if not terminal.closed
        ]

    def windows(self) -> Sequence[Window[object]]:
        """Return the open windows; none without a screen."""
        return self._desk.display.windows if self._desk.display is not None else ()

    def command_of(self, pid: int) -> Sequence[str]:
        """Return the words of a running command of ours; a person's own process has its name already."""
        program = self._desk.programs.get(pid)
        return program.session.argv if program is not None else ()

    def domains(self) -> Mapping[int, Sequence[str]]:
        """Return the domains whose graphs were ever used here."""
        return nodes_by_domain(self._desk.graphs.values())
