"""pyte, imported without the tables of wcwidth: several megabytes, and how wide a character is our screen decides by `width`.

Import pyte's names from here, so that it is always this import that comes first.
"""

from __future__ import annotations

import sys
from types import ModuleType

from day6_tui.core.shell.width import char_width

_is_late = "wcwidth" in sys.modules
if not _is_late:
    _stand_in = ModuleType("wcwidth")
    _stand_in.wcwidth = char_width  # type: ignore[attr-defined]
    sys.modules["wcwidth"] = _stand_in
try:
    from pyte import Screen, Stream, charsets, modes
    from pyte.screens import Char, Cursor
finally:
    if not _is_late:
        del sys.modules["wcwidth"]

__all__ = ["Char", "Cursor", "Screen", "Stream", "charsets", "modes"]
