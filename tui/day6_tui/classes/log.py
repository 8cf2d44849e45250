"""What happened in a lesson (`day6_core/classroom/roster.py`), as a table for a spreadsheet."""

from __future__ import annotations

from collections.abc import Iterable
from datetime import datetime

from day6_core.classroom.roster import ClassEvent
from day6_core.lessons.tables import csv_bytes
from day6_tui.locale import Texts


def as_csv(events: Iterable[ClassEvent], texts: Texts) -> bytes:
    """Return a line for each event: the local time, the pupil, what happened, and its text."""
    heads = [texts(f"class.log.{column}") for column in ClassEvent._fields]
    rows = [
        (
            datetime.fromtimestamp(event.time).strftime("%Y-%m-%d %H:%M:%S"),
            event.name,
            texts(f"class.log.{event.what}"),
            event.text,
        )
        for event in events
    ]
    return csv_bytes(heads, rows)
