"""The few styles of the painted panes and what each means, made from the colours of a theme (`themes.py`).

A `Colours` holds finished, shared `Style` objects: Textual's strips are only cheap when equal styles are the same object.
"""

from __future__ import annotations

from dataclasses import dataclass, fields
from functools import lru_cache

from rich.color import Color
from rich.color_triplet import ColorTriplet
from rich.style import Style

from day6_tui.appearance.themes import palette


@dataclass(frozen=True)
class Colours:
    """Styles by role. Every style names its background, so that a strip needs no other."""

    name: str
    text: Style
    muted: Style
    strong: Style
    frame: Style
    frame_focus: Style
    title: Style
    title_focus: Style
    bar: Style
    bar_strong: Style
    bar_muted: Style
    key: Style
    choice: Style
    node: Style
    topic: Style
    publisher: Style
    warning: Style
    error: Style
    hint: Style
    accent: Style
    terminal: Style
    selection: Style
    dark: bool = True
    colourless: bool = False


_STYLES = {
    "text": ("foreground", "background"),
    "muted": ("muted", "background"),
    "strong": ("bold strong", "background"),
    "frame": ("frame", "background"),
    "frame_focus": ("primary", "background"),
    "title": ("title", "background"),
    "title_focus": ("bold on-primary", "primary"),
    "bar": ("bar-text", "bar"),
    "bar_strong": ("bold bar-strong", "bar"),
    "bar_muted": ("bar-muted", "bar"),
    "key": ("bold key-text", "key"),
    "choice": ("bold on-primary", "primary"),
    "node": ("node", "background"),
    "topic": ("topic", "background"),
    "publisher": ("publisher", "background"),
    "warning": ("bold warning", "background"),
    "error": ("bold error-text", "error"),
    "hint": ("hint-text", "hint"),
    "accent": ("bold primary", "background"),
    "terminal": ("terminal-text", "terminal"),
    "selection": ("selection-text", "selection"),
}
"""The colours of each style, by the theme's names: text and background."""

_SIXTEEN = {"frame_focus": ("node", "background"), "accent": ("node", "background")}
"""On the Linux console the bright colours are lines and letters, the others grounds."""

_PLAIN = {
    **dict.fromkeys(_STYLES, ""),
    "strong": "bold",
    "frame_focus": "bold",
    "title_focus": "bold reverse",
    "bar": "reverse",
    "bar_strong": "bold reverse",
    "bar_muted": "reverse",
    "key": "bold",
    "choice": "reverse",
    "node": "bold",
    "topic": "underline",
    "warning": "bold",
    "error": "bold reverse",
    "hint": "bold reverse",
    "accent": "bold",
    "selection": "reverse",
}


@lru_cache(maxsize=8)
def colours(theme: str = "dark", *, sixteen: bool = False, colourless: bool = False) -> Colours:
    """The styles of a theme. Without colour, or with sixteen, there is one theme only.

    Raises KeyError for an unknown theme.
    """
    if colourless:
        return _build("plain", _PLAIN, dark=True, colourless=True)
    name = "sixteen" if sixteen else theme
    table, roles = palette(name), {**_STYLES, **(_SIXTEEN if sixteen else {})}
    return _build(name, {role: _spec(table, *pair) for role, pair in roles.items()}, dark=name != "light")


def _spec(table: dict[str, str], text: str, ground: str) -> str:
    """Rich's words for a style: its sixteen colours have no `ansi_`, and none of them needs to be bold to stand out."""
    bold, _, colour = text.rpartition(" ")
    front, back = table[colour], table[ground]
    if front.startswith("ansi_"):
        bold = ""
    return f"{bold} {front} on {back}".replace("ansi_", "").strip()


def _build(name: str, table: dict[str, str], *, dark: bool, colourless: bool = False) -> Colours:
    styles = {field.name: Style.parse(table[field.name]) for field in fields(Colours) if field.type == "Style"}
    return Colours(name=name, dark=dark, colourless=colourless, **styles)


@lru_cache(maxsize=4096)
def pixel_style(foreground: int, background: int) -> Style:
    """The shared style of a cell with two colours 0xRRGGBB; -1 means the terminal's own."""
    return Style.from_color(_colour(foreground), _colour(background))


@lru_cache(maxsize=4096)
def _colour(rgb: int) -> Color | None:
    if rgb < 0:
        return None
    return Color.from_triplet(ColorTriplet(rgb >> 16 & 255, rgb >> 8 & 255, rgb & 255))


def background_of(style: Style) -> int:
    """The background of a style as 0xRRGGBB, -1 where it has none."""
    return _number(style.bgcolor)


def foreground_of(style: Style) -> int:
    """The colour of a style's characters as 0xRRGGBB, -1 where it has none."""
    return _number(style.color)


def _number(colour: Color | None) -> int:
    if colour is None:
        return -1
    red, green, blue = colour.get_truecolor()
    return red << 16 | green << 8 | blue


def contrasting(rgb: int) -> int:
    """Black or white, whichever is readable on `rgb` (0xRRGGBB)."""
    red, green, blue = rgb >> 16 & 255, rgb >> 8 & 255, rgb & 255
    return 0x000000 if red * 299 + green * 587 + blue * 114 > 140_000 else 0xFFFFFF
