"""The themes: Textual's `Theme` objects, from which its own widgets and our painted panes (`colours.py`) take their colours.

Hues come from the palette of Okabe and Ito, which stays distinct for colour-blind eyes; hue alone never carries a meaning (the
focused frame is also heavy, a warning also has its mark).
"""

from __future__ import annotations

from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from textual.theme import Theme

_DARK = {
    "background": "#12161d", "foreground": "#d7dde8", "strong": "#ffffff", "muted": "#8492a6", "frame": "#3d4a5c",
    "title": "#9fb0c5", "primary": "#56c8f5", "on-primary": "#0b1016",
    "bar": "#1d2531", "bar-text": "#c3cedd", "bar-strong": "#ffffff", "bar-muted": "#7f8da1",
    "key": "#33445a", "key-text": "#dff3ff",
    "node": "#6fc3f7", "topic": "#f0b429", "publisher": "#3fc9a0", "warning": "#ff9b5e",
    "error": "#b8391f", "error-text": "#ffffff", "hint": "#f0b429", "hint-text": "#0b1016",
    "terminal": "#24101f", "terminal-text": "#eeeeec", "selection": "#9fd8ee", "selection-text": "#0b1016",
    "panel": "#222c3a", "panel-text": "#e3e9f2", "panel-muted": "#98a7bb", "panel-strong": "#ffffff",
    "panel-key": "#8fdcff",
}  # fmt: skip

_LIGHT = {
    "background": "#fafbfc", "foreground": "#1f2733", "strong": "#000000", "muted": "#5d6b7d", "frame": "#b4bfcc",
    "title": "#4a5768", "primary": "#0072b2", "on-primary": "#ffffff",
    "bar": "#e2e8ef", "bar-text": "#263243", "bar-strong": "#000000", "bar-muted": "#5d6b7d",
    "key": "#c3d3e2", "key-text": "#10324a",
    "node": "#005f96", "topic": "#8f5a00", "publisher": "#00704f", "warning": "#b34700",
    "error": "#b8391f", "error-text": "#ffffff", "hint": "#ffd98a", "hint-text": "#1f2733",
    "terminal": "#fffdf7", "terminal-text": "#1f2733", "selection": "#a9d8f0", "selection-text": "#000000",
    "panel": "#e9eef4", "panel-text": "#1f2733", "panel-muted": "#536173", "panel-strong": "#000000",
    "panel-key": "#00578a",
}  # fmt: skip

# For weak eyes and bright rooms: everything that is read has a contrast of at least 7.
_CONTRAST = {
    "background": "#000000", "foreground": "#ffffff", "strong": "#ffffff", "muted": "#c8c8c8", "frame": "#a0a0a0",
    "title": "#ffffff", "primary": "#ffe000", "on-primary": "#000000",
    "bar": "#000000", "bar-text": "#ffffff", "bar-strong": "#ffffff", "bar-muted": "#c8c8c8",
    "key": "#ffffff", "key-text": "#000000",
    "node": "#7fd4ff", "topic": "#ffc233", "publisher": "#5ff0c0", "warning": "#ffab73",
    "error": "#8f0000", "error-text": "#ffffff", "hint": "#ffe000", "hint-text": "#000000",
    "terminal": "#000000", "terminal-text": "#ffffff", "selection": "#ffffff", "selection-text": "#000000",
    "panel": "#000000", "panel-text": "#ffffff", "panel-muted": "#d0d0d0", "panel-strong": "#ffffff",
    "panel-key": "#ffe000",
}  # fmt: skip

# Okabe and Ito's own eight colours; no pair of red and green, and everything that is told apart differs in lightness too.
_COLOUR_BLIND = {
    **_DARK, "background": "#101010", "foreground": "#e8e8e8", "muted": "#9a9a9a", "frame": "#555555",
    "title": "#bdbdbd", "primary": "#56b4e9", "on-primary": "#000000",
    "bar": "#1c1c1c", "bar-text": "#e0e0e0", "bar-muted": "#9a9a9a", "key": "#3a3a3a", "key-text": "#ffffff",
    "node": "#56b4e9", "topic": "#e69f00", "publisher": "#f0e442", "warning": "#e8762b",
    "error": "#0072b2", "error-text": "#ffffff", "hint": "#f0e442", "hint-text": "#000000",
    "terminal": "#000000", "terminal-text": "#e8e8e8", "selection": "#f0e442", "selection-text": "#000000",
    "panel": "#262626", "panel-text": "#f0f0f0", "panel-muted": "#b0b0b0", "panel-key": "#56b4e9",
}  # fmt: skip

# The Linux console: sixteen colours by name, because the nearest of sixteen to a subtle grey is rarely a subtle grey.
_SIXTEEN = {
    "background": "ansi_black", "foreground": "ansi_white", "strong": "ansi_bright_white", "muted": "ansi_cyan",
    "frame": "ansi_bright_black", "title": "ansi_white", "primary": "ansi_cyan", "on-primary": "ansi_black",
    "bar": "ansi_blue", "bar-text": "ansi_white", "bar-strong": "ansi_bright_white", "bar-muted": "ansi_cyan",
    "key": "ansi_white", "key-text": "ansi_black",
    "node": "ansi_bright_cyan", "topic": "ansi_bright_yellow", "publisher": "ansi_bright_green",
    "warning": "ansi_bright_red", "error": "ansi_red", "error-text": "ansi_bright_white", "hint": "ansi_yellow",
    "hint-text": "ansi_black", "terminal": "ansi_black", "terminal-text": "ansi_white", "selection": "ansi_white",
    "selection-text": "ansi_black", "panel": "ansi_blue", "panel-text": "ansi_white", "panel-muted": "ansi_cyan",
    "panel-strong": "ansi_bright_white", "panel-key": "ansi_bright_yellow",
}  # fmt: skip

_PLAIN = dict.fromkeys(_DARK, "ansi_default")

_CHOSEN = {"dark": _DARK, "light": _LIGHT, "contrast": _CONTRAST, "colourblind": _COLOUR_BLIND}
_TABLES = {**_CHOSEN, "sixteen": _SIXTEEN, "plain": _PLAIN}
NAMES = tuple(_CHOSEN)
"""What the user can choose from, where the terminal has the colours."""

_OWN = {"primary": "primary", "secondary": "node", "accent": "topic", "success": "publisher", "warning": "warning",
        "error": "error", "foreground": "foreground", "background": "background", "surface": "panel",
        "panel": "panel"}  # fmt: skip
"""The fields of Textual's Theme, and which of our colours they are."""


def palette(name: str) -> dict[str, str]:
    """The colours of a theme by what they are for. Raises KeyError for an unknown name."""
    return _TABLES[name]


def make_theme(name: str) -> Theme:
    """The theme that Textual's widgets wear: one of `NAMES`, `sixteen` or (without any colour) `plain`."""
    from textual.theme import Theme  # here: the command line asks for the names only

    table = _TABLES[name]
    plain = name == "plain"
    variables = {
        **table,  # for sixteen colours Textual would make surface and panel transparent
        "ansi-background": table["background"],
        "ansi-foreground": table["foreground"],
        "block-cursor-background": table["primary"],
        "block-cursor-foreground": table["on-primary"],
        "block-cursor-text-style": "bold underline" if plain else "bold",
        "block-hover-background": table["key"],
        "button-color-foreground": table["key-text"],
        "button-focus-text-style": "bold reverse" if plain else "bold",
        "input-cursor-background": table["primary"],
        "input-cursor-foreground": table["on-primary"],
        "input-cursor-text-style": "reverse" if plain else "none",
        "input-selection-background": table["selection"],
        "input-selection-foreground": table["selection-text"],
        "markdown-h1-color": table["panel-strong"],
        "markdown-h2-color": table["panel-strong"],
        "screen-selection-background": table["selection"],
        "screen-selection-foreground": table["selection-text"],
        "scrollbar": table["muted"],
        "scrollbar-active": table["primary"],
        "scrollbar-background": table["panel"],
        "scrollbar-background-active": table["panel"],
        "scrollbar-background-hover": table["panel"],
        "scrollbar-corner-color": table["panel"],
        "scrollbar-hover": table["primary"],
    }
    own = {field: table[key] for field, key in _OWN.items()}
    return Theme(name=name, dark=name != "light", ansi=name in ("sixteen", "plain"), variables=variables, **own)  # type: ignore[arg-type]
