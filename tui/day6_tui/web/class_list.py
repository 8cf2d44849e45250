"""Reads the names of a class: a text with one name a line, or a table (CSV) with a column `name`."""

from __future__ import annotations

import codecs
import csv
import io
from dataclasses import dataclass, field
from pathlib import Path
from typing import NamedTuple

from day6_core.classroom.homes import same_name
from day6_core.isolation.cell import Phrase
from day6_core.session.harmless import one_line
from day6_tui.web.names import BadName, clean

COLUMNS = ("name", "姓名", "名字", "学生")
"""What the column of the names may be called."""

LARGEST = 1 << 20
"""Bytes of a list; more is none of a class."""

LONGEST_QUOTE = 40
"""Characters of a bad line that are shown."""


class BadList(Exception):
    """The list cannot be read; `words` say why."""

    def __init__(self, key: str, **values: str) -> None:
        super().__init__(key)
        self.words = Phrase(key, values)


class BadLine(NamedTuple):
    """A line without a name that fits: its number, its text as far as it is shown, and the key of the reason."""

    line: int
    text: str
    why: str


@dataclass
class ClassList:
    """The names in their order, and the lines that have none."""

    names: list[str] = field(default_factory=list)
    bad: list[BadLine] = field(default_factory=list)


def read(path: Path) -> ClassList:
    """Read a list. Raises BadList, OSError."""
    with open(path, "rb") as file:
        data = file.read(LARGEST + 1)
    if len(data) > LARGEST:
        raise BadList("serve.class.large", file=str(path))
    return _parsed(_decoded(data, path))


def _decoded(data: bytes, path: Path) -> str:
    """UTF-8, or what a Chinese Excel writes."""
    if data.startswith((codecs.BOM_UTF16_LE, codecs.BOM_UTF16_BE)):
        encodings = ["utf-16"]
    else:
        encodings = ["utf-8-sig", "gb18030"]
    for encoding in encodings:
        try:
            return data.decode(encoding)
        except UnicodeDecodeError:
            continue
    raise BadList("serve.class.encoding", file=str(path))


def _parsed(text: str) -> ClassList:
    found, known = ClassList(), set[str]()
    lines = io.StringIO(text, newline="").readlines()
    rows = csv.reader(lines, dialect=_dialect(text))
    column: int | None = None
    try:
        for row in rows:
            cells = [each.strip() for each in row]
            if column is None:
                titles = [each.lower() for each in cells]
                column = next((titles.index(title) for title in COLUMNS if title in titles), -1)
                if column >= 0:
                    continue
                column = 0
            if any(cells) and (why := _take(cells[column] if column < len(cells) else "", found, known)):
                found.bad.append(_bad_line(lines, rows.line_num, why))
    except csv.Error:
        found.bad.append(_bad_line(lines, rows.line_num, "serve.class.line"))
    return found


def _bad_line(lines: list[str], number: int, why: str) -> BadLine:
    """What stands in a line is somebody's file: it is shown in short and without what could act on a terminal."""
    text = lines[number - 1].strip()
    short = text if len(text) <= LONGEST_QUOTE else f"{text[: LONGEST_QUOTE - 1]}…"
    return BadLine(number, one_line(short), why)


def _dialect(text: str) -> type[csv.Dialect]:
    first = text.partition("\n")[0]

    class Table(csv.excel):
        delimiter = max(",;\t", key=first.count)

    return Table


def _take(text: str, found: ClassList, known: set[str]) -> str:
    """Take the name of a line; returns the key of the reason if it is none."""
    if not text:
        return "serve.class.nameless"
    try:
        name = clean(text)
    except BadName as error:
        return str(error)
    if same_name(name) in known:
        return "serve.class.twice"
    known.add(same_name(name))
    found.names.append(name)
    return ""
