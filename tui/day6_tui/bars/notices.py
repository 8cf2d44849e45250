"""Notices: one at a time in the key bar, for a few seconds; what does not fit there is Textual's notification."""

from __future__ import annotations

import time
from collections.abc import Callable

from day6_tui.appearance.look import Look
from day6_tui.panes.cells import cell_len

NOTICE_SECONDS = 10.0
"""For what went wrong: long enough to be read, and not pushed aside by the next of its kind."""
HINT_SECONDS = 15.0
"""For a notice that is shown only once."""


class Notices:
    """Holds the current notice and when it expires."""

    def __init__(self, look: Look, room: Callable[[], int], notify: Callable[[str, float], object]) -> None:
        self._look = look
        self._room = room
        self._notify = notify
        self._until = 0.0
        self._lasts = False
        self.text = ""

    def show(self, text: str, seconds: float = 3.0) -> None:
        """Show `text` for this many seconds."""
        lasts = seconds >= NOTICE_SECONDS
        if cell_len(text) > self._room() or (lasts and self._lasts and text != self.text):
            self._notify(text, seconds)
            return
        self.text, self._lasts = text, lasts
        self._until = time.monotonic() + seconds
        self._look.wake()

    def expire(self, now: float) -> bool:
        """Drop a notice that has expired; return True while one is shown."""
        if self._until and now > self._until:
            self.text, self._until, self._lasts = "", 0.0, False
        return bool(self._until)
