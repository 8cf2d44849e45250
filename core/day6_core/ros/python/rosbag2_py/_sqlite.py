"""SQLite bags: the tables of rosbag2_storage_sqlite3 (schema 4; 1 to 3 are read), through Python's own sqlite3."""

from __future__ import annotations

import errno
import os
import sqlite3
from collections.abc import Iterator
from contextlib import contextmanager, suppress
from pathlib import Path
from typing import Any

from rosbag2_py._metadata import MetadataIo
from rosbag2_py._qos import QoS, from_yaml, yaml_lines
from rosbag2_py._storage import (
    BadBag,
    BagMetadata,
    BagTime,
    Duration,
    FileInformation,
    Message,
    MessageDefinition,
    TopicInformation,
    TopicMetadata,
    Wanted,
)

SUFFIX = ".db3"
PRESETS = {
    "none": "Default profile, no special settings.",
    "resilient": "Avoid data corruption in case of crashes at the cost of performance.",
}
SCHEMA_VERSION = 4
BATCH = 512
"""The most messages that wait in memory before they are handed to SQLite."""

_TABLES = """
CREATE TABLE schema(schema_version INTEGER PRIMARY KEY,ros_distro TEXT NOT NULL);
CREATE TABLE metadata(id INTEGER PRIMARY KEY,metadata_version INTEGER NOT NULL,metadata TEXT NOT NULL);
CREATE TABLE topics(id INTEGER PRIMARY KEY,name TEXT NOT NULL,type TEXT NOT NULL,serialization_format TEXT NOT NULL,
offered_qos_profiles TEXT NOT NULL,type_description_hash TEXT NOT NULL);
CREATE TABLE message_definitions(id INTEGER PRIMARY KEY,topic_type TEXT NOT NULL,encoding TEXT NOT NULL,
encoded_message_definition TEXT NOT NULL,type_description_hash TEXT NOT NULL);
CREATE TABLE messages(id INTEGER PRIMARY KEY,topic_id INTEGER NOT NULL,timestamp INTEGER NOT NULL,data BLOB NOT NULL);
CREATE INDEX timestamp_idx ON messages (timestamp ASC);
"""


class SqliteWriter:
    """One file; a flush commits, so a killed recorder loses at most the messages since the last one."""

    storage_id = "sqlite3"
    pieces = 0

    def __init__(self, path: Path, preset: str = "", distro: str = "") -> None:
        if path.exists():
            raise FileExistsError(f"Failed to create bag: File '{path}' already exists!")
        # A user's program may close its recorder on another thread than the one that opened it.
        self._database = sqlite3.connect(path, isolation_level=None, check_same_thread=False)
        self._topics: dict[str, int] = {}
        self._types: set[str] = set()
        self._waiting: list[tuple[int, int, bytes]] = []
        self._waiting_size = 0
        self.metadata: BagMetadata | None = None
        self._failure: OSError | None = None
        """The error after which nothing more is written: the disk is full."""
        with self._writing():
            # A killed process loses nothing that was committed; only a crash of the machine needs `synchronous`.
            self._database.execute(f"PRAGMA synchronous={'NORMAL' if preset == 'resilient' else 'OFF'}")
            self._database.executescript(_TABLES)
            self._database.execute("INSERT INTO schema VALUES (?, ?)", (SCHEMA_VERSION, distro))
            self._database.execute("BEGIN")

    @contextmanager
    def _writing(self) -> Iterator[None]:
        """Turn SQLite's errors into OSError; the file then keeps its last commit, and nothing more is written."""
        if self._failure is not None:
            raise self._failure
        try:
            yield
        except sqlite3.Error as error:
            full = "full" in str(error)
            self._failure = OSError(
                errno.ENOSPC if full else errno.EIO, os.strerror(errno.ENOSPC) if full else str(error)
            )
            with suppress(sqlite3.Error):
                self._database.execute("ROLLBACK")
            raise self._failure from error

    @property
    def size(self) -> int:
        """Size of the file so far, in bytes."""
        (pages,) = self._database.execute("PRAGMA page_count").fetchone()
        (page,) = self._database.execute("PRAGMA page_size").fetchone()
        return int(pages) * int(page) + self._waiting_size

    def create_topic(self, topic: TopicMetadata, definition: MessageDefinition) -> None:
        """Add a topic; does nothing if it exists."""
        if topic.name in self._topics:
            return
        profiles = "\n".join(yaml_lines(topic.offered_qos_profiles))
        with self._writing():
            cursor = self._database.execute(
                "INSERT INTO topics(name, type, serialization_format, offered_qos_profiles, type_description_hash) "
                "VALUES (?, ?, ?, ?, ?)",
                (topic.name, topic.type, topic.serialization_format, profiles, topic.type_description_hash),
            )
            self._topics[topic.name] = int(cursor.lastrowid or 0)
            if topic.type not in self._types:
                self._types.add(topic.type)
                self._database.execute(
                    "INSERT INTO message_definitions(topic_type, encoding, encoded_message_definition, "
                    "type_description_hash) VALUES (?, ?, ?, ?)",
                    (
                        topic.type,
                        definition.encoding,
                        definition.encoded_message_definition,
                        topic.type_description_hash,
                    ),
                )

    def write(self, topic: str, data: bytes, received_ns: int, sent_ns: int) -> None:
        """Add a message (this storage keeps only `received_ns`). Raises KeyError for an unknown topic."""
        self._waiting.append((self._topics[topic], received_ns, data))
        self._waiting_size += len(data)
        if len(self._waiting) >= BATCH:
            self._insert()

    def _insert(self) -> None:
        with self._writing():
            self._database.executemany(
                "INSERT INTO messages(topic_id, timestamp, data) VALUES (?, ?, ?)", self._waiting
            )
        self._waiting.clear()
        self._waiting_size = 0

    def flush(self) -> None:
        """Commit. Raises OSError if the disk is full."""
        self._insert()
        with self._writing():
            self._database.execute("COMMIT")
            self._database.execute("BEGIN")

    def close(self) -> None:
        """Write the metadata of the whole bag and commit for the last time; after a failure only close."""
        try:
            if self._failure is None:
                self._insert()
                with self._writing():
                    if self.metadata is not None:
                        self._database.execute(
                            "INSERT INTO metadata (metadata_version, metadata) VALUES (?, ?)",
                            (self.metadata.version, MetadataIo().serialize_metadata(self.metadata)),
                        )
                    self._database.execute("COMMIT")
        finally:
            self._database.close()


class SqliteReader:
    """One file. Raises RuntimeError if it isn't a bag."""

    storage_id = "sqlite3"
    has_time_order = True

    def __init__(self, path: Path) -> None:
        self._path = path
        if not path.is_file():
            raise BadBag(f"Failed to read from bag: File '{path}' does not exist!")
        # Opened for writing if that is allowed: a killed recorder's unfinished transaction has to be rolled back.
        self._database = sqlite3.connect(path, check_same_thread=False)
        try:
            self._columns = {
                table: [row[1] for row in self._database.execute(f"PRAGMA table_info({table})")]
                for table in ("topics", "messages", "message_definitions", "schema", "metadata")
            }
        except sqlite3.DatabaseError as error:
            self._database.close()
            # Python 3.10 doesn't tell the code; 11 is SQLITE_CORRUPT.
            about = f"SQLite error ({getattr(error, 'sqlite_errorcode', 11)}): {error}"
            raise BadBag(f"Failed to setup storage. Error: Error when processing SQL statement. {about}") from None
        for table in ("topics", "messages"):
            if not self._columns[table]:
                self._database.close()
                raise BadBag(f"field_exists(..) failed. Table `{table}` doesn't exist!")

    def close(self) -> None:
        self._database.close()

    def topics(self) -> dict[int, TopicMetadata]:
        columns = self._columns["topics"]
        found: dict[int, TopicMetadata] = {}
        for row in self.rows(f"SELECT {', '.join(columns)} FROM topics ORDER BY id"):
            values = dict(zip(columns, row, strict=True))
            found[values["id"]] = TopicMetadata(
                id=values["id"],
                name=values["name"],
                type=values["type"],
                serialization_format=values["serialization_format"],
                offered_qos_profiles=_profiles(values.get("offered_qos_profiles", "")),
                type_description_hash=values.get("type_description_hash", ""),
            )
        return found

    def rows(self, query: str, *values: object) -> Iterator[tuple[Any, ...]]:
        try:
            # Closed early, a generator closes what it yields from: the cursor, perhaps after its database. A map is not closed.
            yield from map(tuple, self._database.execute(query, values))
        except sqlite3.DatabaseError as error:
            raise BadBag(f"Error when reading {self._path.name}: {error}") from None

    def metadata(self) -> BagMetadata:
        """Return the metadata of the file alone, as if it were the whole bag."""
        counts = {id_: (count, first, last) for id_, count, first, last in self.rows(
            "SELECT topic_id, COUNT(*), MIN(timestamp), MAX(timestamp) FROM messages GROUP BY topic_id"
        )}  # fmt: skip
        start = min((first for _, first, _ in counts.values()), default=0)
        end = max((last for _, _, last in counts.values()), default=0)
        total = sum(count for count, _, _ in counts.values())
        about = BagMetadata()
        if self._columns["metadata"]:
            for (text,) in self.rows("SELECT metadata FROM metadata ORDER BY id DESC LIMIT 1"):
                about = MetadataIo().deserialize_metadata(text)
        distro = about.ros_distro
        if "ros_distro" in self._columns["schema"]:
            distro = next((row[0] for row in self.rows("SELECT ros_distro FROM schema")), distro)
        return BagMetadata(
            bag_size=self._path.stat().st_size,
            storage_identifier=self.storage_id,
            relative_file_paths=[self._path.name],
            files=[FileInformation(self._path.name, BagTime(start), Duration(0, end - start), total)],
            duration=Duration(0, end - start),
            starting_time=BagTime(start),
            message_count=total,
            topics_with_message_count=[
                TopicInformation(topic, counts.get(id_, (0, 0, 0))[0]) for id_, topic in self.topics().items()
            ],
            custom_data=about.custom_data,
            ros_distro=distro,
        )

    def definitions(self) -> list[MessageDefinition]:
        """Return the texts of the message types; empty for old bags."""
        if not self._columns["message_definitions"]:
            return []
        query = (
            "SELECT topic_type, encoding, encoded_message_definition, type_description_hash FROM message_definitions "
            "ORDER BY id"
        )
        return [MessageDefinition(*row) for row in self.rows(query)]

    def messages(
        self, start_ns: int, wanted: Wanted, *, reverse: bool = False, by_file: bool = False
    ) -> Iterator[Message]:
        """Yield the messages from a time on (reverse: up to it), by time or as they were written."""
        ids = {id_: topic.name for id_, topic in self.topics().items() if wanted(topic.name)}
        direction = " DESC" if reverse else ""
        order = f"id{direction}" if by_file else f"timestamp{direction}, id{direction}"
        listed = ", ".join(map(str, ids))
        rows = self.rows(
            f"SELECT topic_id, timestamp, data FROM messages WHERE timestamp {'<=' if reverse else '>='} ? "
            f"AND topic_id IN ({listed}) ORDER BY {order}",
            start_ns,
        )
        for id_, timestamp, data in rows:
            yield Message(timestamp, 0, ids[id_], bytes(data))


def _profiles(text: str) -> list[QoS]:
    try:
        return from_yaml(text)
    except ValueError:
        return []  # written by a tool that stores something else there: treated as unknown
