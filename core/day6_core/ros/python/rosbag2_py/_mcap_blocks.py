"""The blocks of an MCAP file: the stretches that `McapFile` finds."""

from __future__ import annotations

import sys
from array import array
from collections.abc import Iterator
from pathlib import Path

from mcap.opcode import Opcode

from rosbag2_py._blocks import Block, Entries, Pairs, entries_of
from rosbag2_py._mcap_file import INDEX, MESSAGE_HEAD, PAIR, RECORD, McapFile, Stretch, messages_in, records
from rosbag2_py._storage import Message, MessageDefinition, TopicMetadata


class McapBlocks:
    """One file; see `BlockFile`. A block's place is its stretch, a message's key its offset: in its chunk, or in the file."""

    def __init__(self, path: Path) -> None:
        self._file = McapFile(path)

    @property
    def is_complete(self) -> bool:
        return self._file.is_complete

    @property
    def passed(self) -> float:
        return self._file.passed / self._file.size

    def close(self) -> None:
        self._file.close()

    def topics(self) -> list[TopicMetadata]:
        return self._file.topics()

    def definitions(self) -> list[MessageDefinition]:
        return self._file.definitions()

    def blocks(self) -> Iterator[Block]:
        for stretch in self._file.stretches():
            counts: dict[str, int] = {}
            for channel, count in stretch.counts.items():
                topic = self._file.channels[channel].topic
                counts[topic] = counts.get(topic, 0) + count
            stretch.times, stretch.places = array("q"), array("q")  # read again when they are looked into
            yield Block(stretch.start_ns, stretch.end_ns, counts, stretch)

    def entries(self, block: Block) -> dict[str, Entries]:
        stretch = block.place
        assert isinstance(stretch, Stretch)
        channels = self._file.channels
        with self._file.reading():
            if stretch.chunk is not None and stretch.chunk.message_index_length:
                return self._indexed(stretch)
            found: Pairs = {}
            if stretch.chunk is not None:
                messages = messages_in(self._file.unpack(stretch.chunk.chunk_start_offset))
            else:
                messages = messages_in(self._file.read(stretch.offset, stretch.end - stretch.offset), stretch.offset)
            for channel, time_ns, at in messages:
                if channel in channels:
                    found.setdefault(channels[channel].topic, []).append((time_ns, at))
            return entries_of(found)

    def _indexed(self, stretch: Stretch) -> dict[str, Entries]:
        """By the indexes behind a chunk."""
        chunk = stretch.chunk
        assert chunk is not None
        data = self._file.read(chunk.chunk_start_offset + chunk.chunk_length, chunk.message_index_length)
        found: dict[str, Entries] = {}
        mixed: Pairs = {}
        for opcode, begin, _ in records(data):
            if opcode != Opcode.MESSAGE_INDEX:
                continue
            channel, length = INDEX.unpack_from(data, begin)
            pairs = array("q", data[begin + INDEX.size : begin + INDEX.size + length // PAIR * PAIR])
            if sys.byteorder == "big":
                pairs.byteswap()
            times, keys = pairs[::2], pairs[1::2]
            topic = self._file.channels[channel].topic
            if topic in found or any(times[at] < times[at - 1] for at in range(1, len(times))):
                mixed.setdefault(topic, []).extend(zip(times, keys, strict=True))
            else:
                found[topic] = Entries(times, keys)
        for topic, more in mixed.items():
            before = found.get(topic)
            more += zip(*before, strict=True) if before is not None else ()
        return {**found, **entries_of(mixed)}

    def message(self, block: Block, topic: str, key: int) -> Message:
        stretch = block.place
        assert isinstance(stretch, Stretch)
        with self._file.reading():
            if stretch.chunk is None:
                return self._file.loose_message(key)
            chunk = stretch.chunk
            if not chunk.compression:
                end = chunk.chunk_start_offset + chunk.chunk_length
                return self._file.loose_message(end - chunk.compressed_size + key)
            data = self._file.unpack(chunk.chunk_start_offset)
            _, length = RECORD.unpack_from(data, key)
            begin = key + RECORD.size
            _, _, received, sent = MESSAGE_HEAD.unpack_from(data, begin)
            return Message(received, sent, topic, data[begin + MESSAGE_HEAD.size : begin + length])
