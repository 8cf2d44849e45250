"""How the desktop looks at present: glyphs, colours, language. One object, shared by all panes and changed in place."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, field

from day6_tui.tui.colours import Colours
from day6_tui.tui.glyphs import GlyphSet
from day6_tui.tui.locale import Texts


@dataclass
class Look:
    """Panes read it whenever they draw; who changes it tells them to draw everything again."""

    glyphs: GlyphSet
    colours: Colours
    texts: Texts
    reduced_motion: bool = False
    wake: Callable[[], None] = field(default=lambda: None)
    """Asks for a frame: for panes whose size or state changed by the user's doing."""
