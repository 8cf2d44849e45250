"""The help page (F1) and the command palette, both made from the table of actions."""

from __future__ import annotations

from day6_tui.tui.actions import ACTIONS, Actions, Handlers
from day6_tui.tui.desktop import Desktop
from day6_tui.tui.locale import LANGUAGES, catalogue
from day6_tui.tui.look import Look


class Guidance:
    """Opens the help and the palette over the desktop."""

    def __init__(self, desktop: Desktop, registry: Actions, look: Look) -> None:
        self._desktop = desktop
        self._registry = registry
        self._look = look

    def actions(self) -> Handlers:
        return {"help": self.toggle_help, "palette": self.open_palette}

    def toggle_help(self) -> None:
        from day6_tui.tui.help import HelpOverlay

        if isinstance(self._desktop.overlay, HelpOverlay):
            self._desktop.close_overlay()
        else:
            self._desktop.open_overlay(HelpOverlay(self._look, self._desktop.focused_pane))

    def open_palette(self) -> None:
        """Offer every action of the desktop, searchable by its name in either language."""
        from day6_tui.tui.menu import Entry, Menu

        texts, entries = self._look.texts, []
        for action in ACTIONS:
            if action.palette:
                key = f"action.{action.id}"
                names = [catalogue(language)[key] for language in LANGUAGES]
                choose = self._registry[action.id]
                entries.append(Entry(texts(key), action.label, choose, also=names, words=texts("help." + key)))
        self._desktop.open_overlay(Menu(self._look, "menu.palette", entries))
