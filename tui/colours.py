"""The few colours of the desktop and what each means; dark, light, sixteen-colour and colourless.

Hues come from the palette of Okabe and Ito, which stays distinct for colour-blind eyes; hue alone never carries a meaning (the
focused frame is also heavy, a warning also has its mark). A `Colours` holds finished, shared `Style` objects: Textual's
strips are only cheap when equal styles are the same object.
"""

from __future__ import annotations

from dataclasses import dataclass, fields
from functools import lru_cache

from rich.color import Color
from rich.color_triplet import ColorTriplet
from rich.style import Style


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
    overlay: Style
    overlay_muted: Style
    overlay_frame: Style
    overlay_strong: Style
    overlay_key: Style
    dark: bool = True
    colourless: bool = False


def _style(spec: str) -> Style:
    return Style.parse(spec)


def _build(name: str, table: dict[str, str], *, dark: bool, colourless: bool = False) -> Colours:
    styles = {field.name: _style(table[field.name]) for field in fields(Colours) if field.type == "Style"}
    return Colours(name=name, dark=dark, colourless=colourless, **styles)


_DARK = {
    "text": "#d7dde8 on #12161d",
    "muted": "#8492a6 on #12161d",
    "strong": "bold #ffffff on #12161d",
    "frame": "#3d4a5c on #12161d",
    "frame_focus": "#56c8f5 on #12161d",
    "title": "#9fb0c5 on #12161d",
    "title_focus": "bold #0b1016 on #56c8f5",
    "bar": "#c3cedd on #1d2531",
    "bar_strong": "bold #ffffff on #1d2531",
    "bar_muted": "#7f8da1 on #1d2531",
    "key": "bold #dff3ff on #33445a",
    "choice": "bold #0b1016 on #56c8f5",
    "node": "#6fc3f7 on #12161d",
    "topic": "#f0b429 on #12161d",
    "publisher": "#3fc9a0 on #12161d",
    "warning": "bold #ff9b5e on #12161d",
    "error": "bold #ffffff on #b8391f",
    "hint": "#0b1016 on #f0b429",
    "accent": "bold #56c8f5 on #12161d",
    "terminal": "#eeeeec on #24101f",
    "selection": "#0b1016 on #9fd8ee",
    "overlay": "#e3e9f2 on #222c3a",
    "overlay_muted": "#98a7bb on #222c3a",
    "overlay_frame": "#56c8f5 on #222c3a",
    "overlay_strong": "bold #ffffff on #222c3a",
    "overlay_key": "bold #8fdcff on #222c3a",
}

_LIGHT = {
    "text": "#1f2733 on #fafbfc",
    "muted": "#5d6b7d on #fafbfc",
    "strong": "bold #000000 on #fafbfc",
    "frame": "#b4bfcc on #fafbfc",
    "frame_focus": "#0072b2 on #fafbfc",
    "title": "#4a5768 on #fafbfc",
    "title_focus": "bold #ffffff on #0072b2",
    "bar": "#263243 on #e2e8ef",
    "bar_strong": "bold #000000 on #e2e8ef",
    "bar_muted": "#5d6b7d on #e2e8ef",
    "key": "bold #10324a on #c3d3e2",
    "choice": "bold #ffffff on #0072b2",
    "node": "#005f96 on #fafbfc",
    "topic": "#8f5a00 on #fafbfc",
    "publisher": "#00704f on #fafbfc",
    "warning": "bold #b34700 on #fafbfc",
    "error": "bold #ffffff on #b8391f",
    "hint": "#1f2733 on #ffd98a",
    "accent": "bold #0072b2 on #fafbfc",
    "terminal": "#1f2733 on #fffdf7",
    "selection": "#000000 on #a9d8f0",
    "overlay": "#1f2733 on #e9eef4",
    "overlay_muted": "#536173 on #e9eef4",
    "overlay_frame": "#0072b2 on #e9eef4",
    "overlay_strong": "bold #000000 on #e9eef4",
    "overlay_key": "bold #00578a on #e9eef4",
}

# The Linux console: sixteen colours by name, because the nearest of sixteen to a subtle grey is rarely a subtle grey.
_SIXTEEN = {
    "text": "white on black",
    "muted": "cyan on black",
    "strong": "bright_white on black",
    "frame": "bright_black on black",
    "frame_focus": "bright_cyan on black",
    "title": "white on black",
    "title_focus": "black on cyan",
    "bar": "white on blue",
    "bar_strong": "bright_white on blue",
    "bar_muted": "cyan on blue",
    "key": "black on white",
    "choice": "black on cyan",
    "node": "bright_cyan on black",
    "topic": "bright_yellow on black",
    "publisher": "bright_green on black",
    "warning": "bright_red on black",
    "error": "bright_white on red",
    "hint": "black on yellow",
    "accent": "bright_cyan on black",
    "terminal": "white on black",
    "selection": "black on white",
    "overlay": "white on blue",
    "overlay_muted": "cyan on blue",
    "overlay_frame": "bright_cyan on blue",
    "overlay_strong": "bright_white on blue",
    "overlay_key": "bright_yellow on blue",
}

_PLAIN = {
    **dict.fromkeys(_DARK, ""),
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
    "overlay_frame": "bold",
    "overlay_strong": "bold",
    "overlay_key": "bold",
}

THEMES = ("dark", "light")


@lru_cache(maxsize=8)
def colours(theme: str = "dark", *, sixteen: bool = False, colourless: bool = False) -> Colours:
    """The styles of a theme. Without colour, or with sixteen, there is one theme only."""
    if colourless:
        return _build("plain", _PLAIN, dark=True, colourless=True)
    if sixteen:
        return _build("sixteen", _SIXTEEN, dark=True)
    return _build(theme, _LIGHT if theme == "light" else _DARK, dark=theme != "light")


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
    colour = style.bgcolor
    if colour is None:
        return -1
    red, green, blue = colour.get_truecolor()
    return red << 16 | green << 8 | blue


def contrasting(rgb: int) -> int:
    """Black or white, whichever is readable on `rgb` (0xRRGGBB)."""
    red, green, blue = rgb >> 16 & 255, rgb >> 8 & 255, rgb & 255
    return 0x000000 if red * 299 + green * 587 + blue * 114 > 140_000 else 0xFFFFFF
