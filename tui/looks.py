"""The actions that change the appearance while the desktop runs: language, colours, characters, motion."""

from __future__ import annotations

import os

from textual.app import App

from day6_tui.tui.colours import THEMES, colours
from day6_tui.tui.glyphs import CANVASES, GLYPH_SETS
from day6_tui.tui.look import Look
from day6_tui.tui.pane import Pane


class Looks:
    """Changes the `Look` that all panes of an application share, and redraws them."""

    def __init__(self, app: App[None], look: Look) -> None:
        self._app = app
        self._look = look

    def next_language(self) -> None:
        """中文 or English."""
        look = self._look
        if look.glyphs.chinese:
            look.texts.switch()
            if "DAY6_LANG" in os.environ:  # for programs that explain something
                os.environ["DAY6_LANG"] = look.texts.language
            self.redraw()

    def next_theme(self) -> None:
        """The next set of colours, where the terminal has a choice."""
        present = self._look.colours
        if present.name in THEMES:
            self._look.colours = colours(THEMES[(THEMES.index(present.name) + 1) % len(THEMES)])
            self.redraw()

    def next_glyphs(self) -> str:
        """The next set of characters; returns its name."""
        name = CANVASES[(CANVASES.index(self._look.glyphs.name) + 1) % len(CANVASES)]
        self._look.glyphs = GLYPH_SETS[name]
        self._look.texts.plain = not self._look.glyphs.unicode
        self.redraw()
        return name

    def toggle_motion(self) -> None:
        self._look.reduced_motion = not self._look.reduced_motion
        self.redraw()

    def redraw(self) -> None:
        """Draw every pane with the look as it is now."""
        for pane in self._app.screen.query(Pane):
            pane.restyle()
        self._look.wake()
