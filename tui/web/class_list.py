"""Reads the names of a class: a text with one name a line, or a table (CSV) with a column `name`."""

from __future__ import annotations

import codecs
import csv
import io
from dataclasses import dataclass, field
from pathlib import Path

from day6_tui.core.isolation.cell import Words
from day6_tui.tui.web.names import BadName, clean, same_name

COLUMNS = ("name", "姓名", "名字", "学生")
"""What the column of the names may be called."""

LARGEST = 1 << 20
"""Bytes of a list; more is none of a class."""


class BadList(Exception):
    """The list cannot be read; `words` say why."""

    def __init__(self, key: str, **values: str) -> None:
        super().__init__(key)
        self.words = Words(key, values)


@dataclass
class ClassList:
    """The names in their order, and the lines that have none."""

    names: list[str] = field(default_factory=list)
    bad: list[tuple[int, str]] = field(default_factory=list)
    """The number of a line and the key of the reason."""


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
    rows = csv.reader(io.StringIO(text, newline=""), dialect=_dialect(text))
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
            if any(cells):
                _take(cells[column] if column < len(cells) else "", rows.line_num, found, known)
    except csv.Error:
        found.bad.append((rows.line_num, "serve.class.line"))
    return found


def _dialect(text: str) -> type[csv.Dialect]:
    first = text.partition("\n")[0]

    class Table(csv.excel):
        delimiter = max(",;\t", key=first.count)

    return Table


def _take(text: str, line: int, found: ClassList, known: set[str]) -> None:
    try:
        name = clean(text)
    except BadName as error:
        found.bad.append((line, str(error)))
        return
    if same_name(name) in known:
        found.bad.append((line, "serve.class.twice"))
        return
    known.add(same_name(name))
    found.names.append(name)
