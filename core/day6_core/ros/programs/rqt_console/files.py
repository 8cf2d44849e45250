"""Files of messages as rqt_console writes and reads them: columns between semicolons, every cell in quotation marks."""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from pathlib import Path
from typing import NamedTuple

from day6_core.ros.programs.rqt_console.model import SEVERITIES, Record
from day6_core.session.blocking_files import read_at_most
from day6_core.session.threads import in_thread

SUFFIX = ".csv"

COLUMNS = ("message", "severity", "node", "stamp", "location")

LARGEST = 50_000_000
"""Bytes of a file that is read."""

NO_HEADER = "File does not appear to be a rqt_console message file: missing file header."
SKIPPED = "Skipped {count} rows since they do not appear to be in rqt_console message file format:\n- {reasons}"
"""The words of console_widget.py."""

_BETWEEN = '";"'


class Read(NamedTuple):
    """What a file has: messages numbered from 1 on, and why rows of it were skipped."""

    records: list[Record]
    skipped: list[str]


def written(records: Iterable[Record]) -> str:
    """Return the text of a file of messages."""
    lines = [";".join(COLUMNS)]
    for each in records:
        seconds, nanoseconds = divmod(each.stamp_ns, 1_000_000_000)
        stamp = f"{seconds}.{nanoseconds:09d}"
        cells = (each.text.replace('"', '\\"'), str(each.level), each.node, stamp, each.location)
        lines.append(f'"{_BETWEEN.join(cells)}"')
    return "\n".join(lines) + "\n"


def read(text: str) -> Read:
    """Return the messages of a file's text, in its order. Raises ValueError if it has no header."""
    head, _, rest = text.partition("\n")
    columns = head.strip().split(";")
    if not set(COLUMNS) & set(columns):
        raise ValueError(NO_HEADER)
    found = Read([], [])
    for row in _rows(rest):
        try:
            found.records.append(_record(columns, row, len(found.records) + 1))
        except ValueError as error:
            found.skipped.append(str(error))
    return found


def _rows(text: str) -> Iterator[str]:
    """The rows without the marks around them; a message may have several lines."""
    row: list[str] = []
    for line in text.split("\n"):
        begins = line.startswith('"')
        if begins and len(line) > 1:
            row = []  # one that never ended is no row
        elif not row:
            continue
        row.append(line.rstrip("\r"))
        if line.rstrip("\r").endswith('"') and not line.rstrip("\r").endswith('\\"'):
            yield "\n".join(row)[1:-1]
            row = []


def _record(columns: list[str], row: str, number: int) -> Record:
    cells = row.rsplit(_BETWEEN, len(columns) - 1)
    if len(cells) < len(columns):
        raise ValueError(f"{len(cells)} of {len(columns)} columns")
    values = dict(zip(columns, cells, strict=True))
    for column in columns:
        if column not in (*COLUMNS, "topics"):  # which files of ROS 1 have
            raise ValueError(f"Unknown column: {column}")
    level = values.get("severity", "0")
    if not level.isdecimal() or int(level) not in SEVERITIES:
        raise ValueError(f"Unknown severity value: {level}")
    seconds, dot, nanoseconds = values.get("stamp", "0.0").partition(".")
    if not dot or not seconds.isdecimal() or not nanoseconds.isdecimal():
        raise ValueError(f"Unknown timestamp format: {values.get('stamp')}")
    return Record(
        number,
        values.get("message", "").replace('\\"', '"'),
        int(level),
        values.get("node", ""),
        int(seconds[:12]) * 1_000_000_000 + int(nanoseconds[:9]),
        values.get("location", ""),
    )


async def loaded(path: Path) -> Read:
    """Return what a file has. Raises OSError and ValueError."""
    return await in_thread(lambda: read(read_at_most(path, LARGEST).decode("utf-8", "replace")))
