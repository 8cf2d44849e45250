"""What most of the desktop's features need: made once, before them, and the same until the end."""

from __future__ import annotations

from typing import NamedTuple

from day6_tui.appearance.look import Look
from day6_tui.bars.notices import Notices
from day6_tui.machine import Machine
from day6_tui.panes.desktop import Desktop
from day6_tui.settings import Settings
from day6_tui.terminals.shown import Terminals


class Parts(NamedTuple):
    """The parts of the desktop that features work on."""

    look: Look
    settings: Settings
    machine: Machine
    desktop: Desktop
    notices: Notices
    terminals: Terminals


class Feature:
    """Base of what the desktop does beside showing panes. Its `actions()`, if it has any, are offered by the application."""

    def __init__(self, parts: Parts) -> None:
        self._look, self._settings, self._machine, self._desktop, self._notices, self._terminals = parts
