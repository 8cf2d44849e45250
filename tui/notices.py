"""The short notice in the key bar: one at a time, for a few seconds."""

from __future__ import annotations

import time

from day6_tui.tui.look import Look

HINT_SECONDS = 15.0
"""For a notice that is shown only once."""


class Notices:
    """Holds the current notice and when it expires."""

    def __init__(self, look: Look) -> None:
        self._look = look
        self._until = 0.0
        self.text = ""

    def show(self, text: str, seconds: float = 3.0) -> None:
        """Show `text` for this many seconds."""
        self.text = text
        self._until = time.monotonic() + seconds
        self._look.wake()

    def expire(self, now: float) -> bool:
        """Drop a notice that has expired; return True while one is shown."""
        if self._until and now > self._until:
            self.text, self._until = "", 0.0
        return bool(self._until)
