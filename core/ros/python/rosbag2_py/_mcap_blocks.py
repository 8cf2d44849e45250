"""The blocks of an MCAP file: its chunks, counted by the index at its end; a file without one is gone through once.

The counts of a chunk are not written anywhere, but its message indexes lie one behind the other, and their lengths tell.
"""

from __future__ import annotations

import struct
import sys
from array import array
from collections.abc import Iterator
from contextlib import contextmanager
from io import BytesIO
from itertools import pairwise
from pathlib import Path
from typing import IO, NamedTuple

import zstandard
from mcap.data_stream import ReadDataStream
from mcap.opcode import Opcode
from mcap.reader import SeekingReader
from mcap.records import Channel, Chunk, ChunkIndex, Schema
from mcap.stream_reader import get_chunk_data_stream
from mcap.summary import Summary

from rosbag2_py._blocks import Block, Entries, entries_of
from rosbag2_py._mcap_read import COMPRESSIONS, DAMAGE, MESSAGE_HEAD, definition_of, topic_of
from rosbag2_py._storage import MCAP_MAGIC, BadBag, Message, MessageDefinition, TopicMetadata

_RECORD = struct.Struct("<BQ")
"""Before a record's content: its opcode and its length."""
_CHUNK = struct.Struct("<QQQII")
"""A chunk's content begins with: first and last time, size and CRC of the unpacked messages, length of its compression's name."""
_INDEX = struct.Struct("<HI")
"""A message index begins with: channel, bytes that follow."""
_PAIR = 16
"""Bytes of a message index for one message: its time and its offset in the chunk."""
_LOOSE = 1024
"""Messages outside of chunks that make a block."""
_MOST_UNPACKED = 1 << 30
"""A chunk that would be larger is refused: its few bytes may stand for any size."""


class _InChunk(NamedTuple):
    """Where a block is that is a chunk. Without an index of its messages (`index_length` 0) it is gone through."""

    offset: int
    index_at: int
    index_length: int


class _Outside(NamedTuple):
    """Where messages outside of chunks are: the offsets of the first one and of the end."""

    offset: int
    end: int


class McapBlocks:
    """One file; see `BlockFile`."""

    def __init__(self, path: Path) -> None:
        self._path = path
        self._file: IO[bytes] = path.open("rb")
        self._size = path.stat().st_size
        self._channels: dict[int, Channel] = {}
        self._schemas: dict[int, Schema] = {}
        self._unpacked: tuple[int, bytes] = (-1, b"")
        """The chunk that was unpacked last, by its offset."""
        self.is_complete = True
        try:
            if self._file.read(len(MCAP_MAGIC)) != MCAP_MAGIC:
                raise BadBag(f"{path.name} is not an MCAP file")
            self._summary = self._read_summary()
        except BaseException:
            self._file.close()
            raise

    def close(self) -> None:
        self._file.close()

    def topics(self) -> list[TopicMetadata]:
        found = {channel.topic: channel for channel in self._channels.values()}
        return [topic_of(channel, self._schemas.get(channel.schema_id)) for channel in found.values()]

    def definitions(self) -> list[MessageDefinition]:
        return [definition_of(schema) for schema in self._schemas.values()]

    # -- by the index at the end ---------------------------------------------------------------------------------------

    def _read_summary(self) -> Summary | None:
        """Read the index at the end; None if it is missing or doesn't list the chunks and what is in them."""
        self._file.seek(-len(MCAP_MAGIC), 2)
        if self._file.tell() == 0 or self._file.read() != MCAP_MAGIC:
            self.is_complete = False
            return None
        self._file.seek(0)
        try:
            summary = SeekingReader(self._file, record_size_limit=self._size).get_summary()
        except (*DAMAGE, OSError):  # its offsets may be impossible
            return None
        if summary is None or summary.statistics is None:
            return None
        counted = sum(sum(_counts(index).values()) for index in summary.chunk_indexes)
        known = all(index.message_index_offsets.keys() <= summary.channels.keys() for index in summary.chunk_indexes)
        inside = all(_end_of(index) <= self._size for index in summary.chunk_indexes)
        if counted != summary.statistics.message_count or not known or not inside:
            return None  # messages outside of chunks, or chunks without an index of their messages
        self._channels, self._schemas = summary.channels, summary.schemas
        return summary

    def blocks(self) -> Iterator[Block]:
        if self._summary is None:
            with self._reading():
                yield from self._by_scanning()
            return
        for index in self._summary.chunk_indexes:
            if index.compression not in COMPRESSIONS:
                raise BadBag(f"unsupported compression: {index.compression}")
            counts: dict[str, int] = {}
            for channel, count in _counts(index).items():
                topic = self._channels[channel].topic
                counts[topic] = counts.get(topic, 0) + count
            end = index.chunk_start_offset + index.chunk_length
            place = _InChunk(index.chunk_start_offset, end, index.message_index_length)
            yield Block(index.message_start_time, index.message_end_time, counts, place)

    # -- by going through it -------------------------------------------------------------------------------------------

    def _by_scanning(self) -> Iterator[Block]:
        """Go through the records, from one head to the next; ends where the file was cut off or is damaged."""
        at = len(MCAP_MAGIC)
        outside: list[tuple[int, str]] = []
        begin = at
        while (head := self._head(at)) is not None:
            opcode, length = head
            if opcode == Opcode.MESSAGE:
                channel, _, time_ns, _ = MESSAGE_HEAD.unpack(self._read(at + _RECORD.size, MESSAGE_HEAD.size))
                if channel in self._channels:
                    outside.append((time_ns, self._channels[channel].topic))
            if outside and (opcode == Opcode.CHUNK or len(outside) >= _LOOSE or opcode == Opcode.DATA_END):
                end = at + _RECORD.size + length if opcode == Opcode.MESSAGE else at
                yield _block_of(outside, _Outside(begin, end))
                outside = []
            if opcode == Opcode.DATA_END:
                return
            if opcode in (Opcode.SCHEMA, Opcode.CHANNEL):
                self._note(opcode, self._read(at + _RECORD.size, length))
            elif opcode == Opcode.CHUNK:
                block = self._scanned(at)
                if block is None:
                    break  # it was written only in part
                if block.counts:
                    yield block
            at += _RECORD.size + length
            if not outside:
                begin = at
        self.is_complete = False
        if outside:
            yield _block_of(outside, _Outside(begin, at))

    def _scanned(self, at: int) -> Block | None:
        place = _InChunk(at, 0, 0)
        try:
            data = self._unpack(at, check=True)
            for opcode, begin, end in _records(data, 0, len(data)):
                self._note(opcode, data[begin:end])
            found = [(time_ns, topic) for time_ns, _, topic in self._messages_in(data)]
        except BadBag:
            return None
        return _block_of(found, place) if found else Block(0, 0, {}, place)

    def _head(self, at: int) -> tuple[int, int] | None:
        """The opcode and length of the record at an offset; None if it isn't complete."""
        head = self._read(at, _RECORD.size)
        if len(head) < _RECORD.size:
            return None
        opcode, length = _RECORD.unpack(head)
        return (opcode, length) if at + _RECORD.size + length <= self._size else None

    def _note(self, opcode: int, content: bytes) -> None:
        with self._reading():
            stream = ReadDataStream(BytesIO(content))
            if opcode == Opcode.SCHEMA:
                schema = Schema.read(stream)
                self._schemas[schema.id] = schema
            elif opcode == Opcode.CHANNEL:
                channel = Channel.read(stream)
                self._channels[channel.id] = channel

    # -- inside of blocks ----------------------------------------------------------------------------------------------

    def entries(self, block: Block) -> dict[str, Entries]:
        place = block.place
        with self._reading():
            if isinstance(place, _Outside):
                found: dict[str, list[tuple[int, int]]] = {}
                at = place.offset
                while at < place.end and (head := self._head(at)) is not None:
                    if head[0] == Opcode.MESSAGE:
                        fields = MESSAGE_HEAD.unpack(self._read(at + _RECORD.size, MESSAGE_HEAD.size))
                        if fields[0] in self._channels:
                            found.setdefault(self._channels[fields[0]].topic, []).append((fields[2], at))
                    at += _RECORD.size + head[1]
                return entries_of(found)
            assert isinstance(place, _InChunk)
            if place.index_length:
                return self._indexed(self._read(place.index_at, place.index_length))
            found = {}
            for time_ns, key, topic in self._messages_in(self._unpack(place.offset)):
                found.setdefault(topic, []).append((time_ns, key))
            return entries_of(found)

    def _indexed(self, data: bytes) -> dict[str, Entries]:
        found: dict[str, Entries] = {}
        mixed: dict[str, list[tuple[int, int]]] = {}
        for opcode, begin, _ in _records(data, 0, len(data)):
            if opcode != Opcode.MESSAGE_INDEX:
                continue
            channel, length = _INDEX.unpack_from(data, begin)
            pairs = array("q", data[begin + _INDEX.size : begin + _INDEX.size + length // _PAIR * _PAIR])
            if sys.byteorder == "big":
                pairs.byteswap()
            times, keys = pairs[::2], pairs[1::2]
            topic = self._channels[channel].topic
            if topic in found or any(times[at] < times[at - 1] for at in range(1, len(times))):
                mixed.setdefault(topic, []).extend(zip(times, keys, strict=True))
            else:
                found[topic] = Entries(times, keys)
        for topic, more in mixed.items():
            before = found.get(topic)
            more += zip(*before, strict=True) if before is not None else ()
        return {**found, **entries_of(mixed)}

    def message(self, block: Block, topic: str, key: int) -> Message:
        place = block.place
        with self._reading():
            if isinstance(place, _Outside):
                return self._message(key, topic)
            assert isinstance(place, _InChunk)
            compression, data_at, _ = self._chunk(place.offset)
            if not compression:
                return self._message(data_at + key, topic)
            data = self._unpack(place.offset)
            _, length = _RECORD.unpack_from(data, key)
            begin = key + _RECORD.size
            _, _, received, sent = MESSAGE_HEAD.unpack_from(data, begin)
            return Message(received, sent, topic, data[begin + MESSAGE_HEAD.size : begin + length])

    def _message(self, at: int, topic: str) -> Message:
        """Read the message whose record is at an offset of the file."""
        head = self._head(at)
        if head is None or head[0] != Opcode.MESSAGE:
            raise ValueError("its index is wrong")
        data = self._read(at + _RECORD.size, head[1])
        _, _, received, sent = MESSAGE_HEAD.unpack_from(data)
        return Message(received, sent, topic, data[MESSAGE_HEAD.size :])

    def _chunk(self, offset: int) -> tuple[str, int, int]:
        """The compression of a chunk, the offset of its content in the file, and the length of that."""
        head = self._read(offset + _RECORD.size, _CHUNK.size)
        *_, name_length = _CHUNK.unpack(head)
        at = offset + _RECORD.size + _CHUNK.size
        name = self._read(at, name_length)
        (length,) = struct.unpack("<Q", self._read(at + name_length, 8))
        return name.decode(), at + name_length + 8, length

    def _unpack(self, offset: int, *, check: bool = False) -> bytes:
        """The records in a chunk. The last one is kept: messages beside each other are often wanted together."""
        if self._unpacked[0] == offset:
            return self._unpacked[1]
        with self._reading():
            head = self._head(offset)
            if head is None or head[0] != Opcode.CHUNK:
                raise ValueError("its index is wrong")
            chunk = Chunk.read(ReadDataStream(BytesIO(self._read(offset + _RECORD.size, head[1]))))
            size = chunk.uncompressed_size
            if chunk.compression == "zstd":
                size = max(size, zstandard.frame_content_size(chunk.data))
            if size > _MOST_UNPACKED or chunk.compression not in COMPRESSIONS:
                raise ValueError(f"a chunk of {size} bytes" if size > _MOST_UNPACKED else chunk.compression)
            stream, length = get_chunk_data_stream(chunk, validate_crc=check)
            self._unpacked = (offset, stream.read(length))
        return self._unpacked[1]

    def _messages_in(self, data: bytes) -> Iterator[tuple[int, int, str]]:
        """Time, offset and topic of the messages in an unpacked chunk."""
        for opcode, begin, _ in _records(data, 0, len(data)):
            if opcode == Opcode.MESSAGE:
                channel, _, time_ns, _ = MESSAGE_HEAD.unpack_from(data, begin)
                if channel in self._channels:
                    yield time_ns, begin - _RECORD.size, self._channels[channel].topic

    def _read(self, offset: int, length: int) -> bytes:
        if not 0 <= offset <= self._size:
            raise ValueError("its index is wrong")
        self._file.seek(offset)
        return self._file.read(min(length, self._size))

    @contextmanager
    def _reading(self) -> Iterator[None]:
        try:
            yield
        except BadBag:
            raise
        except DAMAGE as error:
            raise BadBag(f"{self._path.name} is damaged: {error or type(error).__name__}") from error


def _counts(index: ChunkIndex) -> dict[int, int]:
    """The number of a chunk's messages by channel, from the lengths of its message indexes."""
    ends = sorted(index.message_index_offsets.values())
    ends.append(_end_of(index))
    after = dict(pairwise(ends))
    head = _RECORD.size + _INDEX.size
    return {
        channel: (after[offset] - offset - head) // _PAIR for channel, offset in index.message_index_offsets.items()
    }


def _end_of(index: ChunkIndex) -> int:
    return index.chunk_start_offset + index.chunk_length + index.message_index_length


def _records(data: bytes, at: int, end: int) -> Iterator[tuple[int, int, int]]:
    """Opcode, begin and end of the contents of records that lie one behind the other."""
    while at + _RECORD.size <= end:
        opcode, length = _RECORD.unpack_from(data, at)
        at += _RECORD.size
        if at + length > end:
            raise ValueError("a record is not complete")
        yield opcode, at, at + length
        at += length


def _block_of(found: list[tuple[int, str]], place: object) -> Block:
    counts: dict[str, int] = {}
    for _, topic in found:
        counts[topic] = counts.get(topic, 0) + 1
    times = [time_ns for time_ns, _ in found]
    return Block(min(times), max(times), counts, place)
