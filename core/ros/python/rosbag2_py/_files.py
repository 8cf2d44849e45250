"""Which storage a bag has: by what was asked for, by metadata.yaml, by the file's ending and first bytes."""

from __future__ import annotations

import struct
import zlib
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import Protocol

from rosbag2_py import _mcap_records, _mcap_write
from rosbag2_py._mcap_read import Message, Wanted
from rosbag2_py._storage import BagMetadata, MessageDefinition, TopicMetadata, get_default_storage_id

SQLITE_SUFFIX = ".db3"
SUFFIXES = {"mcap": _mcap_write.SUFFIX, "sqlite3": SQLITE_SUFFIX}
MINIMUM_SPLIT = {"mcap": 1024, "sqlite3": 86016}
"""Bytes a file must be allowed to have (rosbag2_storage_mcap, rosbag2_storage_sqlite3)."""

NO_STORAGE = "No storage could be initialized from the inputs."


class BagReader(Protocol):
    """What both storages offer for one file."""

    storage_id: str
    whole: bool

    def metadata(self) -> BagMetadata: ...

    def definitions(self) -> list[MessageDefinition]: ...

    def messages(
        self, start_ns: int, wanted: Wanted, *, reverse: bool = False, by_file: bool = False
    ) -> Iterator[Message]: ...

    def close(self) -> None: ...


class BagWriter(Protocol):
    """What both storages offer for a file that is written."""

    storage_id: str
    metadata: BagMetadata | None

    @property
    def pieces(self) -> int: ...

    @property
    def size(self) -> int: ...

    def create_topic(self, topic: TopicMetadata, definition: MessageDefinition) -> None: ...

    def write(self, topic: str, data: bytes, received_ns: int, sent_ns: int) -> None: ...

    def flush(self) -> None: ...

    def close(self) -> None: ...


@contextmanager
def reading(path: Path) -> Iterator[None]:
    """Inside, what comes of damaged bytes is a RuntimeError that names the file."""
    try:
        yield
    except (struct.error, zlib.error, LookupError, TypeError, ValueError, ArithmeticError, MemoryError) as error:
        raise _mcap_records.BadBag(f"{path.name} is damaged: {error or type(error).__name__}") from error


def get_registered_readers() -> set[str]:
    """Return the storages that can be read."""
    return set(SUFFIXES)


def get_registered_writers() -> set[str]:
    """Return the storages that can be written."""
    return set(SUFFIXES)


def get_registered_serializers() -> set[str]:
    """Return the formats messages can be converted to; there is only CDR, and it needs no converter."""
    return set()


def presets(storage_id: str) -> dict[str, str]:
    """Return the presets of a storage with their descriptions."""
    if storage_id == "mcap":
        return _mcap_write.PRESETS
    from rosbag2_py import _sqlite

    return _sqlite.PRESETS


def storage_of(path: Path, asked: str = "") -> str:
    """Return the storage id of a file; RuntimeError if it is none that can be read."""
    if asked:
        if asked not in SUFFIXES:
            raise RuntimeError(NO_STORAGE)
        return asked
    for name, suffix in SUFFIXES.items():
        if path.suffix == suffix:
            return name
    try:
        with path.open("rb") as file:
            first = file.read(16)
    except OSError:
        raise RuntimeError(NO_STORAGE) from None
    if first.startswith(_mcap_records.MAGIC):
        return "mcap"
    if first.startswith(b"SQLite format 3\0"):
        return "sqlite3"
    raise RuntimeError(NO_STORAGE)


def open_file(path: Path, storage_id: str = "") -> BagReader:
    """Open one file for reading. RuntimeError says what is wrong with it."""
    storage = storage_of(path, storage_id)
    try:
        with reading(path):
            if storage == "mcap":
                from rosbag2_py._mcap_read import McapReader

                return McapReader(path)
            from rosbag2_py._sqlite import SqliteReader

            return SqliteReader(path)
    except OSError as error:
        raise RuntimeError(f"{error.strerror}: {path}") from None


def create_file(path: Path, storage_id: str, preset: str, distro: str) -> BagWriter:
    """Make a new file. RuntimeError for an unknown storage or preset."""
    if (storage_id or get_default_storage_id()) == "mcap":
        return _mcap_write.McapWriter(path, preset)
    from rosbag2_py._sqlite import SqliteWriter

    return SqliteWriter(path, preset, distro)
