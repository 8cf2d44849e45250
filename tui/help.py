"""F1: what the focused pane is, its keys, and the keys that work everywhere, made from the table of actions."""

from __future__ import annotations

from day6_tui.tui.actions import ACTIONS
from day6_tui.tui.look import Look
from day6_tui.tui.overlay import TextOverlay, page_of
from day6_tui.tui.pane import Pane


class HelpOverlay(TextOverlay):
    """Help for `pane`."""

    wanted_width = 76

    def __init__(self, look: Look, pane: Pane) -> None:
        super().__init__(look, "help.title", "help.keys")
        self._page = pane.help_key
        self._hints = [*pane.key_hints(), *pane.more_key_hints()]

    def paragraphs(self) -> list[tuple[str, str]]:
        found = [*page_of(self.look.texts(f"help.{self._page}")), ("overlay", "")]
        found += [("overlay_key", f"{key}\t{name}") for key, name in self._hints]
        return found + self.everywhere()

    def everywhere(self) -> list[tuple[str, str]]:
        """The keys that do not belong to the pane."""
        texts = self.look.texts
        found = [("overlay", "")] if self._hints else []
        found.append(("overlay_strong", texts("help.everywhere")))
        for action in ACTIONS:
            if action.label:
                name = texts("list.head", name=texts("action." + action.id))
                found.append(("overlay", f"{action.label}\t{name}{texts('help.action.' + action.id)}"))
        if self._page != "desk":
            found += [("overlay", ""), ("overlay", texts("help.desk"))]
        return found
