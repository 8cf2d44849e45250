"""The messages of a bag as tables of comma-separated values (RFC 4180), one for each topic; `day6-tui bag-csv` writes them.

A row is a message, a column a value: `pose.position.x`, `ranges[0]`. A sequence has as many columns as the longest one in the bag
has elements, so a topic with sequences is read twice; nothing is kept in memory.
"""

from __future__ import annotations

import csv
import io
import re
from collections.abc import Iterable, Iterator
from contextlib import ExitStack
from pathlib import Path
from typing import TYPE_CHECKING, Any, BinaryIO

from day6_core.interfaces import get_interface, type_name
from day6_core.interfaces.fields import SINGLE
from day6_core.interfaces.registry import structure
from day6_core.whole_file import replacing
from rclpy.serialization import deserialize_message
from rosbag2_py._console import Log
from rosbag2_py._reader import SequentialReader
from rosbag2_py._storage import Message, StorageFilter, StorageOptions, nanoseconds_of

if TYPE_CHECKING:
    from day6_core.interfaces.fields import FieldType

TIMES = ("bag_time", "bag_time_ns")
"""The first columns: seconds since the bag begins, the same for all topics, and exact nanoseconds since 1970."""

MARK = b"\xef\xbb\xbf" + ",".join(TIMES).encode()
"""How each of our files begins. Without the mark before it, spreadsheets of a Chinese Windows read UTF-8 as GBK."""

MOST_COLUMNS = 16_384
"""As many as Excel and LibreOffice show."""

MOST_ELEMENTS = 2_000
"""Of a longer sequence (an image) only the length is written; a laser scan has up to 1,440 ranges."""

AT_ONCE = 200
"""Files that are open at a time."""

SECOND = 1_000_000_000
_FORMULA = ("=", "+", "-", "@", "\t", "\r")
_RESERVED = re.compile(r"(?:con|prn|aux|nul|com\d|lpt\d)", re.IGNORECASE)
"""What no file may be called on Windows."""


class _Value:
    """A single value; the base of what has several columns. A value of None gives empty cells."""

    grows = False
    """Whether the number of columns depends on the messages."""

    def see(self, value: Any) -> None:
        """Learn from a message how long its sequences are."""

    def names(self, name: str, limit: int) -> Iterator[str]:
        """Yield the columns' names; of sequences with more elements than `limit` only the length is written."""
        yield name

    def cells(self, value: Any, limit: int) -> Iterator[object]:
        """Yield the cells of a message."""
        if isinstance(value, str):
            yield f"'{value}" if value.startswith(_FORMULA) else value  # a spreadsheet would run it
        else:
            yield "" if value is None else value[0] if isinstance(value, bytes) else value

    def width(self, limit: int) -> int:
        """Return the number of columns."""
        return 1

    def cut(self, name: str, limit: int) -> Iterator[tuple[str, int]]:
        """Yield the sequences of which only the length is written, each with the greatest."""
        yield from ()


class _Fields(_Value):
    """A message."""

    def __init__(self, name: str) -> None:
        self._parts = [(field.name, _part(field.type)) for field in structure(name).fields]
        self.grows = any(part.grows for _, part in self._parts)

    def see(self, value: Any) -> None:
        for name, part in self._parts:
            if part.grows:
                part.see(getattr(value, name))

    def names(self, name: str, limit: int) -> Iterator[str]:
        for field, part in self._parts:
            yield from part.names(f"{name}.{field}" if name else field, limit)

    def cells(self, value: Any, limit: int) -> Iterator[object]:
        for name, part in self._parts:
            yield from part.cells(None if value is None else getattr(value, name), limit)

    def width(self, limit: int) -> int:
        return sum(part.width(limit) for _, part in self._parts)

    def cut(self, name: str, limit: int) -> Iterator[tuple[str, int]]:
        for field, part in self._parts:
            yield from part.cut(f"{name}.{field}" if name else field, limit)


class _Sequence(_Value):
    """An array or a sequence: the columns of its elements, or its length."""

    grows = True

    def __init__(self, element: _Value) -> None:
        self._element = element
        self._longest = 0

    def see(self, value: Any) -> None:
        self._longest = max(self._longest, len(value))
        if self._element.grows:
            for each in value:
                self._element.see(each)

    def names(self, name: str, limit: int) -> Iterator[str]:
        if self._longest > limit:
            yield f"len({name})"
            return
        for number in range(self._longest):
            yield from self._element.names(f"{name}[{number}]", limit)

    def cells(self, value: Any, limit: int) -> Iterator[object]:
        if self._longest > limit:
            yield "" if value is None else len(value)
            return
        found = [] if value is None else value.tolist() if hasattr(value, "tolist") else value
        for number in range(self._longest):
            yield from self._element.cells(found[number] if number < len(found) else None, limit)

    def width(self, limit: int) -> int:
        return 1 if self._longest > limit else self._longest * self._element.width(limit)

    def cut(self, name: str, limit: int) -> Iterator[tuple[str, int]]:
        if self._longest > limit:
            yield name, self._longest
        elif self._longest:
            yield from self._element.cut(f"{name}[…]", limit)


def _part(kind: FieldType) -> _Value:
    element = _Fields(kind.base) if kind.nested else _Value()
    return element if kind.count == SINGLE else _Sequence(element)


class Table:
    """The messages of one topic as rows. All of them must be seen before the first row."""

    def __init__(self, kind: type[Any]) -> None:
        self._kind = kind
        self._fields = _Fields(type_name(kind))
        self._limit = MOST_ELEMENTS
        self.grows = self._fields.grows
        self.rows = 0
        self.unreadable = 0
        """Messages that don't fit their type."""

    def see(self, message: Message) -> None:
        """Learn the lengths of the sequences in a message."""
        if (found := self._read(message)) is not None:
            self._fields.see(found)

    def head(self) -> list[str]:
        """Return the columns' names, and settle which sequences are too long."""
        while self._limit and self._fields.width(self._limit) + len(TIMES) > MOST_COLUMNS:
            self._limit //= 2
        return [*TIMES, *self._fields.names("", self._limit)]

    def cut(self) -> dict[str, int]:
        """Return the sequences of which only the length is written, each with the greatest."""
        return dict(self._fields.cut("", self._limit))

    def row(self, message: Message, start_ns: int) -> list[object] | None:
        """Return the cells of a message, None for one that doesn't fit its type."""
        found = self._read(message)
        if found is None:
            self.unreadable += 1
            return None
        self.rows += 1
        since = message.received_ns - start_ns
        seconds = f"{'-' * (since < 0)}{abs(since) // SECOND}.{abs(since) % SECOND:09d}"
        return [seconds, message.received_ns, *self._fields.cells(found, self._limit)]

    def _read(self, message: Message) -> Any:
        try:
            return deserialize_message(message.data, self._kind)
        except Exception:
            return None  # whatever is wrong with it, the others are written; `unreadable` counts it


class CsvExport:
    """Opens a bag. Raises RuntimeError, as the reader does. `damage`: where reading ended too early, and why."""

    def __init__(self, bag: str, log: Log) -> None:
        self._reader = SequentialReader(log)
        self._reader.open(StorageOptions(bag))
        metadata = self._reader.get_metadata()
        self._start_ns = nanoseconds_of(metadata.starting_time)
        self.topics = {
            each.topic_metadata.name: each.topic_metadata.type for each in metadata.topics_with_message_count
        }
        self.damage = ""

    def tables(self, topics: Iterable[str]) -> tuple[dict[str, Table], dict[str, str]]:
        """Return the tables of topics, and the types that aren't known here, by topic."""
        tables: dict[str, Table] = {}
        unknown: dict[str, str] = {}
        for topic in topics:
            try:
                tables[topic] = Table(get_interface(self.topics[topic]))
            except Exception:
                unknown[topic] = self.topics[topic]  # not here, or its text is wrong: `unknown` names it
        growing = {topic: table for topic, table in tables.items() if table.grows}
        if growing:
            for message in self._messages(growing):
                growing[message.topic].see(message)
        return tables, unknown

    def write(self, tables: dict[str, Table], files: dict[str, Path]) -> None:
        """Write the tables into files. Raises OSError; then those that weren't finished are as before."""
        names = list(tables)
        for first in range(0, len(names), AT_ONCE):
            self._write({name: tables[name] for name in names[first : first + AT_ONCE]}, files)

    def _write(self, tables: dict[str, Table], files: dict[str, Path]) -> None:
        with ExitStack() as stack:
            writers = {}
            for topic, table in tables.items():
                stream = stack.enter_context(
                    _text(stack.enter_context(replacing(files[topic], mode=0o666, sync=False)))
                )
                writers[topic] = csv.writer(stream, lineterminator="\r\n")
                writers[topic].writerow(table.head())
            for message in self._messages(tables):
                row = tables[message.topic].row(message, self._start_ns)
                if row is not None:
                    writers[message.topic].writerow(row)

    def _messages(self, topics: Iterable[str]) -> Iterator[Message]:
        self._reader.set_filter(StorageFilter(topics=list(topics), services_events=list(topics)))
        self._reader.seek(0)
        try:
            while self._reader.has_next():
                yield self._reader.read_next_message()
        except RuntimeError as error:
            self.damage = str(error)

    def close(self) -> None:
        """Close the bag."""
        self._reader.close()


class _text(io.TextIOWrapper):
    """A text file above a binary one, which stays open."""

    def __init__(self, file: BinaryIO) -> None:
        super().__init__(file, encoding="utf-8-sig", errors="replace", newline="")

    def __exit__(self, *error: object) -> None:
        self.flush()
        self.detach()


def file_names(topics: Iterable[str]) -> dict[str, str]:
    """Return a name for the file of each topic, without what means something in a path; all differ, whatever their case."""
    found: dict[str, str] = {}
    taken: set[str] = set()
    for topic in topics:
        stem = re.sub(r"[^a-zA-Z0-9_]", "_", topic.strip("/"))[:100] or "_"
        if _RESERVED.fullmatch(stem):
            stem += "_"
        name, number = stem, 1
        while name.lower() in taken:
            number += 1
            name = f"{stem}-{number}"
        taken.add(name.lower())
        found[topic] = f"{name}.csv"
    return found


def is_ours(path: Path) -> bool:
    """Return whether a file is an export from here, which may be replaced by another."""
    try:
        with path.open("rb") as file:
            return file.read(len(MARK)) == MARK
    except OSError:
        return False
