"""What happened in a lesson (`day6_core/classroom/journal.py`), as a table for a spreadsheet."""

from __future__ import annotations

from collections.abc import Iterable
from datetime import datetime

from day6_core.classroom.journal import ALL, KINDS, SERVER, ClassEvent
from day6_core.language import said
from day6_core.lessons.tables import csv_bytes
from day6_tui.locale import Texts

COLUMNS = ("time", "by", "name", "what", "text")


def as_csv(events: Iterable[ClassEvent], texts: Texts) -> bytes:
    """Return a line for each event: the local time, who did it, the pupil whom it is about, what happened, and its text."""
    return csv_bytes([texts(f"class.log.{column}") for column in COLUMNS], (_row(event, texts) for event in events))


def _row(event: ClassEvent, texts: Texts) -> tuple[str, ...]:
    everybody = "" if event.by == SERVER else texts("class.log.all")
    return (
        datetime.fromtimestamp(event.time).strftime("%Y-%m-%d %H:%M:%S"),
        texts(f"class.log.by.{event.by}"),
        everybody if event.name == ALL else event.name,
        said(KINDS[event.what].text, texts.language),
        event.text,
    )
