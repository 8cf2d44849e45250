"""Which characters this terminal can show: glyph sets, and the choice between them.

The facts behind the sets: emulators show half blocks and braille; the fonts of the Linux console mostly
have neither, but they have the line drawing and the shapes of the old IBM code page; without UTF-8 only ASCII is safe.
"""

from __future__ import annotations

import os
import sys
from collections.abc import Mapping
from dataclasses import dataclass
from pathlib import Path

from day6_core.session.harmless import has_colours

CANVASES = ("half", "braille", "cell", "ascii")
PIXELS = "pixels"
"""The set for terminals that show real pixels, once they have said so (day6_tui/pixels); what is not drawn so has half blocks."""


@dataclass(frozen=True)
class Border:
    """The eight characters of a frame."""

    top_left: str
    top_right: str
    bottom_left: str
    bottom_right: str
    horizontal: str
    vertical: str


ROUND = Border("╭", "╮", "╰", "╯", "─", "│")
HEAVY = Border("┏", "┓", "┗", "┛", "━", "┃")
SINGLE = Border("┌", "┐", "└", "┘", "─", "│")
DOUBLE = Border("╔", "╗", "╚", "╝", "═", "║")
PLAIN = Border("+", "+", "+", "+", "-", "|")
PLAIN_STRONG = Border("#", "#", "#", "#", "=", "#")


@dataclass(frozen=True)
class GlyphSet:
    """One choice of characters. `canvas` says how pixels become cells; every symbol is one cell wide."""

    name: str
    canvas: str
    border: Border
    strong_border: Border
    """For the focused pane; it differs in shape too, for eyes and terminals without colour."""
    news: str
    chevron: str
    running: str
    paused: str
    warning: str
    dot: str
    ellipsis: str
    marker: str
    close: str
    bars: str
    """From nothing to full, for a sparkline."""
    unicode: bool

    @property
    def chinese(self) -> bool:
        """Whether such terminals have Chinese characters: the Linux console's fonts never do."""
        return self.canvas in ("half", "braille")


_SYMBOLS = {
    "news": "●", "chevron": "▸", "running": "►", "paused": "‖", "warning": "▲", "dot": "·", "ellipsis": "…",
    "marker": "▸", "close": "×", "bars": " ▁▂▃▄▅▆▇█", "unicode": True,
}  # fmt: skip
_CONSOLE_SYMBOLS = {
    **_SYMBOLS,
    "news": "•",
    "chevron": "»",
    "marker": "»",
    "paused": "=",
    "ellipsis": "~",
    "bars": " .░▒█",
}
_ASCII_SYMBOLS = {
    "news": "*", "chevron": ">", "running": ">", "paused": "=", "warning": "!", "dot": "|", "ellipsis": "~",
    "marker": ">", "close": "x", "bars": " .:-=+*#", "unicode": False,
}  # fmt: skip

GLYPH_SETS: dict[str, GlyphSet] = {
    PIXELS: GlyphSet(PIXELS, "half", ROUND, HEAVY, **_SYMBOLS),  # type: ignore[arg-type]
    "half": GlyphSet("half", "half", ROUND, HEAVY, **_SYMBOLS),  # type: ignore[arg-type]
    "braille": GlyphSet("braille", "braille", ROUND, HEAVY, **_SYMBOLS),  # type: ignore[arg-type]
    "cell": GlyphSet("cell", "cell", SINGLE, DOUBLE, **_CONSOLE_SYMBOLS),  # type: ignore[arg-type]
    "ascii": GlyphSet("ascii", "ascii", PLAIN, PLAIN_STRONG, **_ASCII_SYMBOLS),  # type: ignore[arg-type]
}


def terminal_environ() -> Mapping[str, str]:
    """The environment as the terminal gave it.

    Python itself sets LC_CTYPE=C.UTF-8 when it finds the C locale (PEP 538), and Textual removes NO_COLOR.
    """
    try:
        raw = Path("/proc/self/environ").read_bytes()
    except OSError:
        return os.environ
    pairs = (entry.partition(b"=") for entry in raw.split(b"\0") if b"=" in entry)
    return {os.fsdecode(name): os.fsdecode(value) for name, _, value in pairs}


def is_colourless(environ: Mapping[str, str]) -> bool:
    """Whether no colours are wanted, or the terminal has none."""
    return bool(environ.get("NO_COLOR")) or not has_colours(environ)


def speaks_utf8(environ: Mapping[str, str], platform: str = sys.platform) -> bool:
    """Whether the terminal's locale is UTF-8. Windows terminals are, whatever the code page says."""
    if platform == "win32":
        return True
    for name in ("LC_ALL", "LC_CTYPE", "LANG"):
        if value := environ.get(name):
            return "utf8" in value.lower().replace("-", "")
    return platform == "darwin"


def sends_alt(environ: Mapping[str, str], platform: str = sys.platform) -> bool:
    """Whether Alt with a key arrives. These terminals of macOS type signs by Option until somebody changes their settings."""
    program = environ.get("TERM_PROGRAM", "")
    return program not in ("Apple_Terminal", "iTerm.app") and not (program == "vscode" and platform == "darwin")


def detect(environ: Mapping[str, str] | None = None, platform: str = sys.platform) -> str:
    """The name of the glyph set for this terminal, judged by its environment."""
    environ = terminal_environ() if environ is None else environ
    if not speaks_utf8(environ, platform):
        return "ascii"
    if environ.get("TERM", "") in ("linux", "dumb", "vt100", "vt220"):
        # Coloured cells need colour: without it the same drawing is made of characters.
        return "ascii" if environ.get("NO_COLOR") or environ.get("TERM") != "linux" else "cell"
    return "half"


def choose(name: str | None, environ: Mapping[str, str] | None = None) -> GlyphSet:
    """The glyph set called `name` (`PIXELS` or any of `CANVASES`), or the detected one for None and 'auto'.

    Raises KeyError for another name.
    """
    return GLYPH_SETS[detect(environ) if name in (None, "", "auto") else str(name)]
