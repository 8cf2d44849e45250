"""The index of a bag's file by blocks: where its messages are, without reading them.

A block is a stretch of a file with a few hundred to a few thousand messages: a chunk of MCAP, some rows of SQLite. Of each only
its times and its counts are kept, so that a file of gigabytes takes a few megabytes of memory; the times of its messages are
read when a block is looked into, their bytes when they are needed. The real tools have nothing like it: rqt_bag reads all
messages of a bag for its timeline.
"""

from __future__ import annotations

from array import array
from collections.abc import Iterable, Iterator
from dataclasses import dataclass, field
from pathlib import Path
from typing import NamedTuple, Protocol

from rosbag2_py._files import reading, storage_of
from rosbag2_py._storage import Message, MessageDefinition, TopicMetadata


class Entries(NamedTuple):
    """The messages of one topic in a block, by time: nanoseconds since 1970, and where each is (for `BlockFile.message`)."""

    times: array[int]
    keys: array[int]


@dataclass(slots=True, eq=False)
class Block:
    """A stretch of a file: the times of its first and last message, and the number of messages by topic."""

    start_ns: int
    end_ns: int
    counts: dict[str, int]
    place: object
    """Where it is, for the file that made it."""
    number: int = 0
    """Its place among all blocks, given by whoever collects them."""
    entries: dict[str, Entries] | None = field(default=None, repr=False)
    """What `BlockFile.entries` returned, while somebody keeps it here."""


class BlockFile(Protocol):
    """One file of either storage. Only one thread at a time may use it. All methods raise RuntimeError for damaged files."""

    @property
    def is_complete(self) -> bool:
        """Whether the file goes on to its regular end, as far as `blocks` has come."""

    @property
    def passed(self) -> float:
        """Which part of the file `blocks` has gone through, 0 to 1."""

    def blocks(self) -> Iterator[Block]:
        """Yield the blocks in the order of the file."""

    def entries(self, block: Block) -> dict[str, Entries]:
        """Return the times and places of the block's messages by topic."""

    def message(self, block: Block, topic: str, key: int) -> Message:
        """Read one message."""

    def topics(self) -> list[TopicMetadata]:
        """Return the topics, as far as `blocks` has come."""

    def definitions(self) -> list[MessageDefinition]:
        """Return the texts of the message types."""

    def close(self) -> None: ...


def open_blocks(path: Path, storage_id: str = "") -> BlockFile:
    """Open one file. Raises RuntimeError with the reason."""
    with reading(path):
        if storage_of(path, storage_id) == "mcap":
            from rosbag2_py._mcap_blocks import McapBlocks

            return McapBlocks(path)
        from rosbag2_py._sqlite_blocks import SqliteBlocks

        return SqliteBlocks(path)


Pairs = dict[str, list[tuple[int, int]]]
"""The time and the key of messages, by topic."""


def entries_of(found: Pairs) -> dict[str, Entries]:
    """Pack them, sorted by time; messages of the same time stay in the order of the file."""
    return {topic: _packed(sorted(pairs)) for topic, pairs in found.items()}


def _packed(pairs: Iterable[tuple[int, int]]) -> Entries:
    times, keys = array("q"), array("q")
    for time_ns, key in pairs:
        times.append(time_ns)
        keys.append(key)
    return Entries(times, keys)
