"""Fits a running desktop to another terminal, which may show fewer characters and colours than the one before, or more.

What the person had chosen stays where the terminal can show it, and comes back with a terminal that can.
"""

from __future__ import annotations

import os
from collections.abc import Mapping
from functools import lru_cache
from typing import TYPE_CHECKING

from rich.color import Color, ColorSystem
from rich.segment import Segment
from rich.style import Style
from textual import constants
from textual.color import Color as Ground
from textual.filter import LineFilter, Monochrome, NoColor

from day6_core.language import language_of
from day6_tui.appearance import glyphs
from day6_tui.appearance.colours import colours
from day6_tui.appearance.glyphs import CANVASES, GLYPH_SETS, PIXELS
from day6_tui.appearance.themes import NAMES, make_theme

if TYPE_CHECKING:
    from day6_tui.app import Day6App

_SHOWN_BY = {CANVASES[0]: (PIXELS, *CANVASES), "cell": CANVASES[2:], "ascii": CANVASES[3:]}
"""The sets of characters that a terminal can show for which `glyphs.detect` chooses the first one."""

_SYSTEMS = {"kitty": ColorSystem.EIGHT_BIT, "256color": ColorSystem.EIGHT_BIT}


def colour_system(environ: Mapping[str, str]) -> ColorSystem:
    """How many colours a terminal has, judged as Rich does."""
    if environ.get("COLORTERM", "").strip().lower() in ("truecolor", "24bit"):
        return ColorSystem.TRUECOLOR
    return _SYSTEMS.get(environ.get("TERM", "").strip().lower().rpartition("-")[2], ColorSystem.STANDARD)


@lru_cache(maxsize=16384)
def _fewer(style: Style, system: ColorSystem) -> Style:
    front, ground = style.color, style.bgcolor
    return style + Style.from_color(_nearest(front, system), _nearest(ground, system))


def _nearest(colour: Color | None, system: ColorSystem) -> Color | None:
    return None if colour is None else colour.downgrade(system)


class FewerColours(LineFilter):
    """Replaces colours by the nearest ones that the terminal has.

    Rich would do that, too, but remembers in every style how it was written for the first terminal.
    """

    def __init__(self, system: ColorSystem) -> None:
        super().__init__()
        self.system = system

    def apply(self, segments: list[Segment], background: Ground) -> list[Segment]:
        system = self.system
        return [
            Segment(text, style if style is None else _fewer(style, system), control)
            for text, style, control in segments
        ]


class Adaptation:
    """Changes the look of an application when its terminal changes."""

    def __init__(self, app: Day6App) -> None:
        self._app = app
        environ = glyphs.terminal_environ()
        self._kind = glyphs.detect(environ) if environ.get("TERM", "dumb") not in ("", "dumb") else ""
        """The set of characters that would be chosen for the present terminal; '' if there never was one."""
        self._worn: dict[str, tuple[str | None, str]] = {}
        """Characters and language that the person had on terminals of each kind."""
        self._theme = NAMES[0]

    def begin(self) -> None:
        """Write all colours in full from now on, so that they can be fitted to any terminal. Before anything is drawn."""
        if constants.COLOR_SYSTEM == "auto":
            self._app.console._color_system = ColorSystem.TRUECOLOR
            self._limit_colours(glyphs.terminal_environ())

    def fit(self, environ: Mapping[str, str]) -> None:
        """Take another terminal, which these variables describe."""
        app, look = self._app, self._app.look
        pictures, worn = look.pictures, look.glyphs.name
        if worn == CANVASES[0] and (pictures is None or (pictures.wanted and pictures.ability is None)):
            worn = PIXELS if app.options.glyphs in (None, PIXELS) else worn  # wherever they can be shown
        spoken = look.texts.language
        if self._kind:
            self._worn[self._kind] = worn, spoken
        else:
            spoken = language_of(environ)
        self._kind = kind = glyphs.detect(environ)
        known, language = self._worn.get(kind, (app.options.glyphs, app.options.lang or spoken))
        wanted = known if known in _SHOWN_BY[kind] else _SHOWN_BY[kind][0]
        look.glyphs = GLYPH_SETS[CANVASES[0] if wanted == PIXELS else wanted]
        look.texts.plain = not look.glyphs.unicode
        look.alt = glyphs.sends_alt(environ)
        look.letters, look.chinese = glyphs.speaks_utf8(environ), GLYPH_SETS[kind].chinese
        if (language if look.chinese else "en") != look.texts.language:
            look.texts.switch()
            os.environ["DAY6_LANG"] = look.texts.language
        self._fit_colours(environ)
        look.pictures = None
        app.begin_pictures(wanted, environ)
        app.looks.redraw()
        for screen in app.screen_stack:
            for widget in screen.walk_children(with_self=True):
                widget.refresh()

    def _fit_colours(self, environ: Mapping[str, str]) -> None:
        app, look = self._app, self._app.look
        if look.colours.name in NAMES:
            self._theme = look.colours.name
        sixteen = environ.get("TERM") == "linux" and not environ.get("COLORTERM")
        colourless = glyphs.is_colourless(environ)
        look.colours = colours(self._theme, sixteen=sixteen, colourless=colourless)
        app._filters = [each for each in app._filters if not isinstance(each, (NoColor, Monochrome))]
        if colourless:
            app._filters.append(NoColor())
        app.no_color = colourless
        app.register_theme(make_theme(look.colours.name))
        app.ansi_color = not look.has_shades
        app.theme = look.colours.name
        if constants.COLOR_SYSTEM == "auto":
            self._limit_colours(environ)

    def _limit_colours(self, environ: Mapping[str, str]) -> None:
        system = colour_system(environ)
        self._app.look.filters = [] if system is ColorSystem.TRUECOLOR else [FewerColours(system)]
