"""The blocks of an SQLite bag: rows in the order in which they were written, counted by SQLite itself."""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path

from rosbag2_py._blocks import Block, Entries, Pairs, entries_of
from rosbag2_py._files import reading
from rosbag2_py._sqlite import SqliteReader
from rosbag2_py._storage import BadBag, Message, MessageDefinition, TopicMetadata

LEAST_ROWS = 512
MOST_BLOCKS = 4096
"""A longer file has more rows in a block."""


class SqliteBlocks:
    """One file; see `BlockFile`."""

    is_complete = True

    def __init__(self, path: Path) -> None:
        self._path = path
        self._file = SqliteReader(path)
        self.passed = 0.0
        try:
            self._names = {id_: topic.name for id_, topic in self._file.topics().items()}
        except BaseException:
            self._file.close()
            raise

    def close(self) -> None:
        self._file.close()

    def topics(self) -> list[TopicMetadata]:
        return list(self._file.topics().values())

    def definitions(self) -> list[MessageDefinition]:
        return self._file.definitions()

    def blocks(self) -> Iterator[Block]:
        with reading(self._path):
            (least, most), *_ = self._file.rows("SELECT MIN(id), MAX(id) FROM messages")
            rows = 0 if least is None else max(LEAST_ROWS, (most - least) // MOST_BLOCKS)
            after = least - 1 if rows else 0
            while rows:
                found = list(self._file.rows(
                    "SELECT topic_id, COUNT(*), MIN(timestamp), MAX(timestamp), MAX(id) FROM "
                    "(SELECT id, topic_id, timestamp FROM messages WHERE id > ? ORDER BY id LIMIT ?) GROUP BY topic_id",
                    after, rows,
                ))  # fmt: skip
                if not found:
                    return
                before, after = after, max(row[4] for row in found)
                counts = {self._names[row[0]]: row[1] for row in found if row[0] in self._names}
                start, end = min(row[2] for row in found), max(row[3] for row in found)
                self.passed = (after - least) / (most - least) if most > least else 1.0
                yield Block(int(start), int(end), counts, (before + 1, after))

    def entries(self, block: Block) -> dict[str, Entries]:
        found: Pairs = {}
        with reading(self._path):
            assert isinstance(block.place, tuple)
            query = "SELECT id, topic_id, timestamp FROM messages WHERE id BETWEEN ? AND ?"
            for id_, topic, timestamp in self._file.rows(query, *block.place):
                if topic in self._names:
                    found.setdefault(self._names[topic], []).append((timestamp, id_))
            return entries_of(found)

    def message(self, block: Block, topic: str, key: int) -> Message:
        with reading(self._path):
            for timestamp, data in self._file.rows("SELECT timestamp, data FROM messages WHERE id = ?", key):
                return Message(timestamp, 0, topic, bytes(data))
        raise BadBag(f"{self._path.name} is damaged: message {key} is missing")
