"""The desktop's current appearance: glyphs, colours, language. One object, shared by all panes and changed in place."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, field

from day6_tui.tui.colours import Colours
from day6_tui.tui.glyphs import GlyphSet
from day6_tui.tui.locale import Texts


@dataclass
class Look:
    """Panes read it whenever they draw; the code that changes it makes them redraw everything."""

    glyphs: GlyphSet
    colours: Colours
    texts: Texts
    reduced_motion: bool = False
    wake: Callable[[], None] = field(default=lambda: None)
    """Requests a frame: for panes whose size or state the user changed."""
