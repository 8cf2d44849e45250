"""Textual's log without its thread."""

from __future__ import annotations

from textual.widgets import Log

from day6_tui.panes.cells import cell_len


class LogView(Log):
    """Measures its lines at once.

    Log does that in a worker, which asks the widget for its application. Where the widget is not mounted yet, or not any
    more, that fails, and a failed worker ends the whole application.
    """

    def _update_size(self, updates: int, lines: list[str]) -> None:  # type: ignore[override]
        if lines:
            self._update_maximum_width(updates, max(cell_len(self._process_line(line)) for line in lines))
