"""Reads a cast file: its head and its events, each line checked. What is wrong is told with its line."""

from __future__ import annotations

import json
import math
import re
from collections.abc import Iterator
from pathlib import Path
from typing import NamedTuple, TypeGuard

LARGEST_FILE = 256_000_000
"""Bytes. Hours of a desktop take a tenth of it."""

LONGEST_LINE = 8_000_000

LARGEST_SCREEN = 1000
"""Columns or rows."""

LONGEST_SECONDS = 7 * 24 * 3600.0

_SIZE = re.compile(r"([0-9]{1,4})x([0-9]{1,4})")


class CastError(Exception):
    """A file that is no cast: `key` of the text that says what is wrong, the `line` (1 the first) and its values."""

    def __init__(self, key: str, line: int = 0, **values: object) -> None:
        super().__init__(key)
        self.key, self.line, self.values = key, line, values


class CastEvent(NamedTuple):
    """At `time` (s) after the beginning: `text` was shown ("o"), or the screen got another size ("r")."""

    time: float
    kind: str
    text: str
    size: tuple[int, int] = (0, 0)


class Cast(NamedTuple):
    """A recording: columns and rows at the beginning, and its events in order of time."""

    size: tuple[int, int]
    events: tuple[CastEvent, ...]

    @property
    def seconds(self) -> float:
        return self.events[-1].time if self.events else 0.0


def read(path: Path) -> Cast:
    """Read a cast. Raises OSError if it cannot be read, CastError if it is none."""
    if path.is_dir():
        raise IsADirectoryError(21, "Is a directory", str(path))
    with open(path, "rb") as file:
        data = file.read(LARGEST_FILE + 1)
    if len(data) > LARGEST_FILE:
        raise CastError("large", most=LARGEST_FILE // 1_000_000)
    try:
        text = data.decode("utf-8")
    except UnicodeDecodeError as error:
        raise CastError("text", data.count(b"\n", 0, error.start) + 1) from None
    lines = text.split("\n")
    size = _head(lines[0])
    return Cast(size, tuple(_events(lines)))


def _head(line: str) -> tuple[int, int]:
    head = _json(line, 1)
    if not isinstance(head, dict) or "version" not in head:
        raise CastError("head", 1)
    if head["version"] != 2:
        raise CastError("version", 1, version=str(head["version"])[:20])
    width, height = head.get("width"), head.get("height")
    if not _is_size(width) or not _is_size(height):
        raise CastError("size", 1, most=LARGEST_SCREEN)
    return width, height


def _is_size(value: object) -> TypeGuard[int]:
    return isinstance(value, int) and not isinstance(value, bool) and 1 <= value <= LARGEST_SCREEN


def _events(lines: list[str]) -> Iterator[CastEvent]:
    before = 0.0
    last = len(lines)
    for number, line in enumerate(lines[1:], 2):
        if not line.strip():
            continue
        try:
            found = _json(line, number)
        except CastError:
            if number == last:  # cut off, as a recording that was killed leaves it
                return
            raise
        if not isinstance(found, list) or len(found) != 3:
            raise CastError("event", number)
        time, kind, text = found
        if isinstance(time, bool) or not isinstance(time, (int, float)):
            raise CastError("time", number)
        if not before <= time <= LONGEST_SECONDS or not math.isfinite(time):
            raise CastError("time", number)
        if not isinstance(kind, str) or not isinstance(text, str):
            raise CastError("event", number)
        before = float(time)
        if kind == "o":
            yield CastEvent(before, kind, text)
        elif kind == "r":
            match = _SIZE.fullmatch(text)
            size = (int(match[1]), int(match[2])) if match else (0, 0)
            if not (_is_size(size[0]) and _is_size(size[1])):
                raise CastError("size", number, most=LARGEST_SCREEN)
            yield CastEvent(before, kind, "", size)


def _json(line: str, number: int) -> object:
    if len(line) > LONGEST_LINE:
        raise CastError("long", number)
    try:
        return json.loads(line)
    except (ValueError, RecursionError):
        raise CastError("json" if number > 1 else "head", number) from None
