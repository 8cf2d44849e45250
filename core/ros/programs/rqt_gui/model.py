"""Which plugins `rqt` offers, in the groups of its menu."""

from __future__ import annotations

from collections.abc import Callable
from typing import NamedTuple


class Plugin(NamedTuple):
    """A window: its place in rqt's menu, and the package whose executable of the same name opens it."""

    group: str
    title: str
    package: str


PLUGINS = (
    Plugin("Introspection", "Node Graph", "rqt_graph"),
    Plugin("Logging", "Console", "rqt_console"),
    Plugin("Topics", "Topic Monitor", "rqt_topic"),
    Plugin("Visualization", "Plot", "rqt_plot"),
)


def find(word: str) -> Plugin | None:
    """Return the plugin that a word of the command line names: 'rqt_plot', or a part of it that only one has."""
    fitting = [plugin for plugin in PLUGINS if word.lower() in f"{plugin.package} {plugin.title.lower()}"]
    return fitting[0] if len(fitting) == 1 else None


class Menu:
    """The model: `choose` is called by the window, on any thread."""

    def __init__(self, on_choice: Callable[[], None]) -> None:
        self.plugins = PLUGINS
        self.chosen: Plugin | None = None
        self._on_choice = on_choice

    def choose(self, plugin: Plugin) -> None:
        """Open this window in place of the menu."""
        self.chosen = plugin
        self._on_choice()
