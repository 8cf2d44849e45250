"""The teacher's own words: they stand in the column `remark` of the CSV, and stay there however often is graded again."""

from __future__ import annotations

import csv
import io
from pathlib import Path

from day6_core.lessons.tables import without_guard

COLUMN, KEY = "remark", "file"
_CODINGS = ("utf-8-sig", "gb18030")
"""As it is written, and as spreadsheets in China save it."""


class Unreadable(Exception):
    """A file in which there may be words that nobody can read; it must not be overwritten."""


def read(path: Path | None) -> dict[str, str]:
    """The words for each file of a submission; none where there is no table yet. Raises Unreadable, OSError."""
    if path is None or not path.exists():
        return {}
    data = path.read_bytes()
    if not data.strip():
        return {}
    for coding in _CODINGS:
        try:
            text = data.decode(coding)
        except UnicodeDecodeError:
            continue
        if "\0" not in text and (rows := _rows(text)) is not None:
            return rows
    raise Unreadable(str(path))


def _line(text: str) -> str:
    return " ".join(map(str.strip, text.splitlines())).strip()


def _rows(text: str) -> dict[str, str] | None:
    """The words, None if this is no table of marks. Spreadsheets save it with other signs between the columns, too."""
    for sign in ",;\t":
        try:
            reader = csv.DictReader(io.StringIO(text, newline=""), delimiter=sign, strict=True)
            rows = list(reader)
        except csv.Error:
            continue
        if KEY in (reader.fieldnames or ()):
            words = {without_guard(row[KEY] or ""): _line(without_guard(row.get(COLUMN) or "")) for row in rows}
            return {name: each for name, each in words.items() if name and each}
    return None
