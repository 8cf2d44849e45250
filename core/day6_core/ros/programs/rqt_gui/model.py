"""What rqt's own window shows: the plugins, those that are open, and the perspectives."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path
from typing import NamedTuple

from day6_core.ros.programs.rqt_gui.catalogue import PluginEntry


class Open(NamedTuple):
    """A plugin that is open: its number among those of the same kind is 1 for the first one."""

    entry: PluginEntry
    serial: int

    @property
    def title(self) -> str:
        return self.entry.title if self.serial < 2 else f"{self.entry.title} ({self.serial})"


class Request(NamedTuple):
    """What the window asks for: the name of a method of the program's `Container`, and what it gets."""

    deed: str
    subject: object


class Rqt:
    """The model. The window reads its attributes and calls its methods, on any thread."""

    def __init__(self, plugins: tuple[PluginEntry, ...], path: Callable[[str], Path], wake: Callable[[], None]) -> None:
        self.plugins = plugins
        self.open: tuple[Open, ...] = ()
        """In the order in which they were opened."""
        self.perspective = ""
        self.perspectives: tuple[str, ...] = ()
        self.trouble = ""
        """Why the last request failed, in words of the system or of rqt; '' if it did not."""
        self.version = 0
        self.requests: list[Request] = []
        """What is to be done and what is being done, the oldest first."""
        self.path = path
        """The file that a user of this program means."""
        self._wake = wake

    def start(self, entry: PluginEntry) -> None:
        """Open a plugin, once more if it is open."""
        self._ask("start", entry)

    def stop(self, plugin: Open) -> None:
        """Close a plugin."""
        self._ask("stop", plugin)

    def switch(self, perspective: str) -> None:
        """Close all plugins and open those of a perspective; one that does not exist is empty."""
        self._ask("switch", perspective)

    def keep_as(self, perspective: str) -> None:
        """Make a perspective of the plugins that are open."""
        self._ask("keep_as", perspective)

    def remove(self, perspective: str) -> None:
        """Forget a perspective that is not the current one."""
        self._ask("remove", perspective)

    def load(self, name: str) -> None:
        """Open the perspective of a file."""
        self._ask("load", self.path(name))

    def export(self, name: str) -> None:
        """Write the perspective to a file."""
        self._ask("export", self.path(name))

    def _ask(self, deed: str, subject: object) -> None:
        self.requests.append(Request(deed, subject))
        self._wake()
