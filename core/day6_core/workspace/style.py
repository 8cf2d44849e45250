"""The colours of what went wrong, in colcon's output on a terminal.

colcon_core (0.19 and later, output_style) names what can be styled; the codes are those of its maintainer's extension
`ansi_colors`. A plain Ubuntu has no such extension and prints the same words in one colour, so what went well stays plain here.
"""

from __future__ import annotations

from collections.abc import Mapping
from enum import Enum

from day6_core.session.streams import OutputStream

_PLAIN = ("", "0", "no", "No", "NO", "false", "False", "FALSE")
"""Values of NO_COLOR that do not ask for plain text."""


class Style(Enum):
    """What a text is, with the codes before and after it."""

    CRITICAL = ("1;31", "0;22")
    ERROR = ("31", "0")
    WARNING = ("33", "0")


class Styler:
    """Colours texts for a stream, if that is a terminal and colours are wanted."""

    def __init__(self, stream: OutputStream, environment: Mapping[str, str]) -> None:
        self._active = stream.isatty() and environment.get("NO_COLOR", "") in _PLAIN

    def __call__(self, style: Style, text: str) -> str:
        """Return `text` with the codes of its style."""
        if not self._active:
            return text
        before, after = style.value
        return f"\x1b[{before}m{text}\x1b[{after}m"
