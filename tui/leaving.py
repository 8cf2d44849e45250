"""Leaving the desktop: not before the user knows what would be lost."""

from __future__ import annotations

from textual.app import App

from day6_tui.tui.desktop import Desktop
from day6_tui.tui.look import Look


class Leaving:
    """Ends the application, of which it only uses `exit`."""

    def __init__(self, app: App[None], desktop: Desktop, look: Look) -> None:
        self._app = app
        self._desktop = desktop
        self._look = look

    def lost(self) -> list[str]:
        """What the windows cannot keep if the desktop ends now, each with the reason."""
        return [lost for pane in self._desktop.panes.values() if (lost := pane.loses_at_the_end())]

    def quit(self) -> None:
        """End the desktop; ask first if a text would be lost because there is no room for a copy of it."""
        lost = self.lost()
        if not lost:
            self._app.exit()
            return
        from day6_tui.tui.prompt import Question

        texts = self._look.texts
        title = texts("quit.lost", what="; ".join(lost))
        self._desktop.open_overlay(Question(self._look, texts("quit.title"), title, {"y": self._app.exit}))

    def end_by_signal(self) -> None:
        """End after a closed terminal or `kill`: the user cannot be asked, but what is lost is reported."""
        lost = self.lost()
        if lost:
            self._app.exit(return_code=1, message=self._look.texts("quit.was_lost", what="; ".join(lost)))
        else:
            self._app.exit()
