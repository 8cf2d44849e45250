"""The actions that change the appearance while the desktop runs: language, theme, characters, motion."""

from __future__ import annotations

import os
from collections.abc import Callable
from functools import partial

from textual.app import App

from day6_tui.appearance.colours import colours
from day6_tui.appearance.glyphs import CANVASES, GLYPH_SETS, PIXELS
from day6_tui.appearance.look import Look
from day6_tui.appearance.themes import NAMES, make_theme
from day6_tui.overlays.modal import Modal
from day6_tui.panes.pane import Pane


class Looks:
    """Changes the `Look` that all panes of an application share, and redraws them."""

    def __init__(self, app: App[None], look: Look) -> None:
        self._app = app
        self._look = look
        for name in {*NAMES, look.colours.name}:
            app.register_theme(make_theme(name))
        # Before the application runs: setting it the usual way would compute all styles twice.
        app.set_reactive(App.theme, look.colours.name)
        app.stylesheet.set_variables(app.get_css_variables())

    def next_language(self) -> None:
        """中文 or English."""
        look = self._look
        if look.chinese:
            look.texts.switch()
            if "DAY6_LANG" in os.environ:  # for programs that explain something
                os.environ["DAY6_LANG"] = look.texts.language
            self.redraw()

    @property
    def has_choice(self) -> bool:
        """Whether the terminal has enough colours for more than one theme."""
        return self._look.colours.name in NAMES

    def theme_menu(self, chosen: Callable[[str], object]) -> Modal:
        """The list of the themes; `chosen` is told when the user has decided."""
        from day6_tui.overlays.menu import Menu, MenuEntry

        texts = self._look.texts

        def take(name: str) -> None:
            self.wear(name)
            chosen(name)

        entries = [MenuEntry(texts(f"theme.{name}"), name, partial(take, name)) for name in NAMES]
        return Menu(self._look, "theme.title", entries, chosen=NAMES.index(self._look.colours.name))

    def wear(self, name: str) -> None:
        """Take the colours of a theme."""
        self._look.colours = colours(name)
        self._app.theme = name
        self.redraw()

    def next_glyphs(self) -> str:
        """The next set of characters; returns its name."""
        pictures = self._look.pictures
        names = (PIXELS, *CANVASES) if pictures is not None and pictures.ability is not None else CANVASES
        present = self._look.glyphs.name
        name = names[(names.index(present) + 1) % len(names)] if present in names else names[0]
        self._look.glyphs = GLYPH_SETS[name]
        self._look.texts.plain = not self._look.glyphs.unicode
        self.redraw()
        return name

    def toggle_motion(self) -> None:
        self._look.reduced_motion = not self._look.reduced_motion
        self.redraw()

    def redraw(self) -> None:
        """Draw every pane with the look as it is now."""
        redraw(self._app, self._look)


def redraw(app: App[None], look: Look) -> None:
    """Draw every pane of an application with the look as it is now."""
    for screen in app.screen_stack:
        for pane in screen.query(Pane):
            pane.restyle()
    look.wake()
