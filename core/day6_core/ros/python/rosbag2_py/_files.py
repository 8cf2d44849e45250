"""Detects a bag's storage: from the given id, metadata.yaml, or the file's extension and first bytes."""

from __future__ import annotations

import struct
import zlib
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import Protocol

from rosbag2_py._console import Log
from rosbag2_py._storage import (
    MCAP_MAGIC,
    BadBag,
    BagMetadata,
    Message,
    MessageDefinition,
    TopicMetadata,
    Wanted,
    get_default_storage_id,
)

SQLITE_SUFFIX = ".db3"
SUFFIXES = {"mcap": ".mcap", "sqlite3": SQLITE_SUFFIX}
MCAP_PRESETS = {
    "none": "Default profile, no special settings.",
    "fastwrite": "Disables CRC and chunking for faster writing.",
    "zstd_fast": "Use Zstd chunk compression on Fastest level.",
    "zstd_small": "Use Zstd chunk compression on Slowest level, for smallest file size.",
}
MINIMUM_SPLIT = {"mcap": 1024, "sqlite3": 86016}
"""The smallest allowed size limit of a file, in bytes (rosbag2_storage_mcap, rosbag2_storage_sqlite3)."""

_LOGGER = "rosbag2_storage"
NO_STORAGE = "No storage could be initialized from the inputs."


class BagReader(Protocol):
    """The reader of one file, of either storage."""

    storage_id: str

    @property
    def has_time_order(self) -> bool:
        """Whether its messages can be read by time."""

    def metadata(self) -> BagMetadata: ...

    def definitions(self) -> list[MessageDefinition]: ...

    def messages(
        self, start_ns: int, wanted: Wanted, *, reverse: bool = False, by_file: bool = False
    ) -> Iterator[Message]: ...

    def close(self) -> None: ...


class BagWriter(Protocol):
    """The writer of one file, of either storage."""

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
    """Turn the errors that damaged bytes and files out of reach cause into a BadBag that names the file."""
    try:
        yield
    except OSError as error:
        raise BadBag(f"{error.strerror}: {path}") from error
    except (struct.error, zlib.error, LookupError, TypeError, ValueError, ArithmeticError, MemoryError) as error:
        raise BadBag(f"{path.name} is damaged: {error or type(error).__name__}") from error


def get_registered_readers() -> set[str]:
    """Return the storages that can be read."""
    return set(SUFFIXES)


def get_registered_writers() -> set[str]:
    """Return the storages that can be written."""
    return set(SUFFIXES)


def get_registered_serializers() -> set[str]:
    """Return the formats that messages can be converted to: none, because CDR needs no converter."""
    return set()


def presets(storage_id: str) -> dict[str, str]:
    """Return the presets of a storage with their descriptions."""
    if storage_id == "mcap":
        return MCAP_PRESETS
    from rosbag2_py import _sqlite

    return _sqlite.PRESETS


def storage_of(path: Path, storage_id: str = "") -> str:
    """Return the storage id of a file. Raises RuntimeError if it can't be read."""
    if storage_id:
        if storage_id not in SUFFIXES:
            raise RuntimeError(NO_STORAGE)
        return storage_id
    with path.open("rb") as file:
        first = file.read(16)
    if first.startswith(MCAP_MAGIC):
        return "mcap"
    if first.startswith(b"SQLite format 3\0"):
        return "sqlite3"
    for name, suffix in SUFFIXES.items():
        if path.suffix == suffix:
            return name
    raise RuntimeError(NO_STORAGE)


def open_file(path: Path, storage_id: str, log: Log) -> BagReader | None:
    """Open one file for reading; None if that can't be: the reason is logged (rosbag2_storage, StorageFactory)."""
    try:
        file = _open(path, storage_id)
    except RuntimeError as error:
        if not storage_id:
            log("ERROR", _LOGGER, "No storage id specified, and no plugin found that could open URI")
            return None
        if storage_id in SUFFIXES:
            reason = error.__cause__.strerror if isinstance(error.__cause__, OSError) else error
            log("ERROR", _LOGGER, f"Could not open '{path}' with '{storage_id}'. Error: {reason}")
        log("ERROR", _LOGGER, f"Could not load/open plugin with storage id '{storage_id}'")
        return None
    if file.storage_id == "sqlite3":
        log("INFO", _LOGGER, f"Opened database '{path}' for READ_ONLY.")
    return file


def _open(path: Path, storage_id: str) -> BagReader:
    with reading(path):
        if storage_of(path, storage_id) == "mcap":
            from rosbag2_py._mcap_read import McapReader

            return McapReader(path)
        from rosbag2_py._sqlite import SqliteReader

        return SqliteReader(path)


def create_file(path: Path, storage_id: str, preset: str, distro: str, log: Log) -> BagWriter:
    """Create a new file. Raises RuntimeError for an unknown storage or preset."""
    if (storage_id or get_default_storage_id()) == "mcap":
        from rosbag2_py._mcap_write import McapWriter

        return McapWriter(path, preset)
    from rosbag2_py._sqlite import SqliteWriter

    file = SqliteWriter(path, preset, distro)
    log("INFO", _LOGGER, f"Opened database '{path}' for READ_WRITE.")
    return file
