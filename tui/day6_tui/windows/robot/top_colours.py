"""The colours of a robot from above in a theme."""

from __future__ import annotations

from dataclasses import replace
from functools import lru_cache

from day6_tui.appearance.colours import Colours, background_of
from day6_urdf.topview.paint import DARK, LIGHT, TopColours


@lru_cache(maxsize=8)
def top_colours(colours: Colours) -> TopColours:
    """What the URDF leaves open, for the ground of these colours."""
    return replace(DARK if colours.dark else LIGHT, background=background_of(colours.text))
