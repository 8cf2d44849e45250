"""pyte, imported without wcwidth's tables: they take several megabytes, and our screen measures characters with `width`.

Import pyte's names from here, so that this import always comes first.
"""

from __future__ import annotations

import sys
from types import ModuleType

from day6_core.width import char_width

_is_late = "wcwidth" in sys.modules
if not _is_late:
    _stand_in = ModuleType("wcwidth")
    _stand_in.wcwidth = char_width  # type: ignore[attr-defined]
    sys.modules["wcwidth"] = _stand_in
try:
    from pyte import Screen, Stream, charsets, modes
    from pyte.screens import Char, Cursor, StaticDefaultDict
finally:
    if not _is_late:
        del sys.modules["wcwidth"]


class Line(StaticDefaultDict[int, Char]):
    """The cells of a line that were drawn, by their column; a blank where another one is asked for."""

    folded = False
    """Whether its text goes on in the next line, because it came to the right edge."""


__all__ = ["Char", "Cursor", "Line", "Screen", "Stream", "charsets", "modes"]
