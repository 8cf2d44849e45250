"""One MCAP file: what is in it and where, by the summary at its end; a file without one is gone through, head by head.

Behind each chunk lie the indexes of its messages, one for each channel, and their lengths tell how many messages there are. So a
file that was cut off is gone through without unpacking its chunks, but the first one, which names the channels, and the last one,
whose indexes may be missing. What only unpacking would show is not found then: topics without a message, first named in a later
chunk, and damage inside of one.
"""

from __future__ import annotations

import struct
from array import array
from collections.abc import Iterator
from contextlib import contextmanager
from dataclasses import dataclass, field
from io import BytesIO
from itertools import pairwise
from pathlib import Path
from typing import IO

from mcap.data_stream import ReadDataStream
from mcap.exceptions import McapError
from mcap.opcode import Opcode
from mcap.reader import SeekingReader
from mcap.records import Channel, Chunk, ChunkIndex, Metadata, Schema
from mcap.stream_reader import get_chunk_data_stream
from mcap.summary import Summary

from rosbag2_py._compression import MissingCodec, codec
from rosbag2_py._metadata import MetadataIo
from rosbag2_py._qos import QoS, from_yaml
from rosbag2_py._storage import MCAP_MAGIC, BadBag, BagMetadata, Message, MessageDefinition, TopicMetadata

try:
    from zstandard import ZstdError
except ImportError:  # then it raises none
    ZstdError = McapError  # type: ignore[misc,assignment]

COMPRESSIONS = {"", "zstd", "lz4"}
"""The formats of compressed chunks; the library treats any other as not compressed."""
DAMAGE = (McapError, ZstdError, RuntimeError, struct.error, ValueError, LookupError, OverflowError, MemoryError)
"""The errors that the library raises for damaged bytes; lz4 raises RuntimeError."""
MESSAGE_HEAD = struct.Struct("<HIQQ")
"""The fields before a message's data: channel, sequence number, time received, time sent."""
RECORD = struct.Struct("<BQ")
"""Before a record's content: its opcode and its length."""
INDEX = struct.Struct("<HI")
"""A message index begins with: channel, bytes that follow."""
PAIR = 16
"""Bytes of a message index for one message: its time and its offset in the chunk."""
LOOSE = 1024
"""Messages outside of chunks that make a stretch."""
_MOST_LOOSE = 1 << 22
"""Bytes of them."""
_CHUNK = struct.Struct("<QQQII")
"""A chunk's content begins with: first and last time, size and CRC of the unpacked messages, length of its compression's name."""
_SHORTEST = {Opcode.MESSAGE: MESSAGE_HEAD.size, Opcode.MESSAGE_INDEX: INDEX.size, Opcode.CHUNK: _CHUNK.size}
"""Bytes of a record's content at least."""
_LONGEST_NAME = 32
"""Of a compression."""
_HEADS = RECORD.size + MESSAGE_HEAD.size
_LEAST_PIECE, _MOST_PIECE = 1 << 12, 1 << 20
"""Bytes that are read at once: after a jump, and when heads lie close together."""
_MOST_UNPACKED = 1 << 30
"""A chunk that would be larger is refused: its few bytes may stand for any size."""
_SMALLEST = 25 + 37
"""Bytes of a file at least: its magic with an empty header, and a footer (mcap/internal.hpp)."""


@dataclass(slots=True)
class Stretch:
    """Messages that lie together: a chunk, or messages outside of chunks from one offset to another."""

    start_ns: int = 0
    end_ns: int = 0
    counts: dict[int, int] = field(default_factory=dict)
    """Messages by channel."""
    chunk: ChunkIndex | None = None
    """Without message indexes (`message_index_length` 0) it has to be unpacked to find its messages."""
    offset: int = 0
    end: int = 0
    times: array[int] = field(default_factory=lambda: array("q"))
    places: array[int] = field(default_factory=lambda: array("q"))
    """Times, and offsets of the records, of messages outside of chunks, in the order of the file."""

    def add(self, channel: int, time_ns: int, place: int) -> None:
        """Add a message outside of chunks."""
        self.count(channel, time_ns)
        self.times.append(time_ns)
        self.places.append(place)

    def add_index(self, channel: int, count: int, place: int, length: int) -> None:
        """Add the message index of a channel behind the chunk."""
        assert self.chunk is not None
        self.chunk.message_index_offsets[channel] = place
        self.chunk.message_index_length += length
        self.counts[channel] = count

    def is_long(self, end: int) -> bool:
        """Whether another one is to begin at `end`."""
        return len(self.times) >= LOOSE or end - self.offset > _MOST_LOOSE

    def until(self, end: int) -> Stretch:
        """End it there."""
        self.end = end
        return self

    def count(self, channel: int, time_ns: int) -> None:
        """Count a message."""
        self.start_ns = min(self.start_ns, time_ns) if self.counts else time_ns
        self.end_ns = max(self.end_ns, time_ns)
        self.counts[channel] = self.counts.get(channel, 0) + 1


class McapFile:
    """Raises BadBag (RuntimeError) for what is no MCAP file, and in all methods for damage."""

    def __init__(self, path: Path) -> None:
        self.path = path
        self.stream: IO[bytes] = path.open("rb")
        self.size = path.stat().st_size
        self.channels: dict[int, Channel] = {}
        self.schemas: dict[int, Schema] = {}
        self.about: BagMetadata | None = None
        """What rosbag2 has written into the file of the whole bag."""
        self.is_complete = True
        """Whether the file goes on to its regular end, as far as it was gone through."""
        self.passed = 0
        """Bytes that were gone through."""
        self._unpacked: tuple[int, bytes] = (-1, b"")
        """The chunk that was unpacked last, by its offset."""
        try:
            # The texts of mcap/reader.inl, McapReader::open.
            if self.size < _SMALLEST:
                raise BadBag("file too small")
            magic = self.stream.read(len(MCAP_MAGIC))
            if magic != MCAP_MAGIC:
                raise BadBag(f"invalid magic bytes in Header: 0x{magic.hex().upper()}")
            self.summary = self._read_summary()
        except BaseException:
            self.stream.close()
            raise

    def close(self) -> None:
        self.stream.close()

    def topics(self) -> list[TopicMetadata]:
        """The topics, as far as the file was gone through."""
        found = {channel.topic: channel for channel in self.channels.values()}
        return [_topic_of(channel, self.schemas.get(channel.schema_id)) for channel in found.values()]

    def definitions(self) -> list[MessageDefinition]:
        """The texts of the message types, as far as the file was gone through."""
        return [
            MessageDefinition(schema.name, schema.encoding, schema.data.decode("utf-8", "replace"), "")
            for schema in self.schemas.values()
        ]

    @contextmanager
    def reading(self) -> Iterator[None]:
        """Turn the library's errors for damaged bytes into a BadBag that names the file."""
        try:
            yield
        except (BadBag, MissingCodec):
            raise
        except DAMAGE as error:
            raise BadBag(f"{self.path.name} is damaged: {error or type(error).__name__}") from error

    # -- the summary ---------------------------------------------------------------------------------------------------

    def _read_summary(self) -> Summary | None:
        """Read the index at the end, with its statistics; None if it is missing or can't be true."""
        self.stream.seek(-len(MCAP_MAGIC), 2)
        if self.stream.read() != MCAP_MAGIC:
            self.is_complete = False
            return None
        self.stream.seek(0)
        reader = SeekingReader(self.stream, record_size_limit=self.size)
        try:
            summary = reader.get_summary()
            if summary is None or summary.statistics is None:
                return None
            for metadata in reader.iter_metadata():
                self._note_metadata(metadata)
        except (*DAMAGE, OSError):  # its offsets may be impossible
            return None
        if any(_end_of(index) > self.size for index in summary.chunk_indexes):
            return None
        self.channels, self.schemas = summary.channels, summary.schemas
        return summary

    @property
    def is_indexed(self) -> bool:
        """Whether the summary tells of every message in which chunk it is."""
        if self.summary is None or self.summary.statistics is None:
            return False
        indexes = self.summary.chunk_indexes
        counted = sum(sum(_counts(index).values()) for index in indexes)
        known = all(index.message_index_offsets.keys() <= self.channels.keys() for index in indexes)
        return known and counted == self.summary.statistics.message_count

    def stretches(self) -> Iterator[Stretch]:
        """Yield what is in the file, in its order: by the summary, if every message is in it."""
        with self.reading():
            if self.summary is None or not self.is_indexed:
                yield from self._walk()
                return
            for index in self.summary.chunk_indexes:
                check_compression(index.compression)
                yield Stretch(index.message_start_time, index.message_end_time, _counts(index), index)
            self.passed = self.size

    # -- going through it ----------------------------------------------------------------------------------------------

    def _walk(self) -> Iterator[Stretch]:
        """Go from one head to the next; ends where the file was cut off or is damaged."""
        has_end, self.is_complete = self.is_complete, False
        heads, at = _Heads(self), len(MCAP_MAGIC)
        loose, packed = Stretch(offset=at), None
        while (head := heads.at(at)) is not None:
            (opcode, end), self.passed = head, at
            if packed is not None and opcode != Opcode.MESSAGE_INDEX:
                if not self._complete(packed):
                    packed = None
                    break
                yield packed
                packed = None
            if opcode == Opcode.MESSAGE:
                channel, _, time_ns, _ = heads.content(MESSAGE_HEAD)
                if channel in self.channels:
                    loose.add(channel, time_ns, at)
            elif opcode == Opcode.MESSAGE_INDEX and packed is not None:
                channel, length = heads.content(INDEX)
                packed.add_index(channel, length // PAIR, at, end - at)
            elif opcode in (Opcode.SCHEMA, Opcode.CHANNEL, Opcode.METADATA):
                self._take(opcode, self.read(at + RECORD.size, end - at - RECORD.size))
            if not loose.times and opcode != Opcode.MESSAGE:
                loose.offset = end
            elif loose.times and (opcode in (Opcode.CHUNK, Opcode.DATA_END) or loose.is_long(end)):
                yield loose.until(end if opcode == Opcode.MESSAGE else at)
                loose = Stretch(offset=end)
            if opcode == Opcode.CHUNK:
                packed, loose = self._chunk_at(at, end - at), Stretch(offset=end)
            elif opcode == Opcode.DATA_END:
                self.is_complete = has_end
                break
            at = end
        if packed is not None and self._complete(packed, at_end=True):
            yield packed
        if loose.times:
            yield loose.until(at)
        self.passed = self.size

    def _chunk_at(self, at: int, length: int) -> Stretch:
        """The stretch of a chunk whose record has so many bytes, without what the indexes behind it tell."""
        start, end, size, _, name_length = _CHUNK.unpack(self.read(at + RECORD.size, _CHUNK.size))
        if name_length > _LONGEST_NAME:
            raise ValueError("the name of a compression is too long")
        name = self.read(at + RECORD.size + _CHUNK.size, name_length).decode()
        check_compression(name)
        packed = length - RECORD.size - _CHUNK.size - name_length - 8
        index = ChunkIndex(length, at, name, packed, end, 0, {}, start, size)
        return Stretch(start, end, {}, index)

    def _complete(self, packed: Stretch, *, at_end: bool = False) -> bool:
        """Unpack a chunk whose channels are not known, or whose indexes may be missing; False if that can't be."""
        index = packed.chunk
        assert index is not None
        counted = bool(packed.counts) and not at_end
        if counted and packed.counts.keys() <= self.channels.keys():
            return True
        try:
            data = self.unpack(index.chunk_start_offset, check=True)
            for opcode, begin, end in records(data):
                if opcode in (Opcode.SCHEMA, Opcode.CHANNEL):
                    self._take(opcode, data[begin:end])
        except BadBag:
            return False  # it was written only in part
        if not counted:
            index.message_index_length, index.message_index_offsets = 0, {}
            packed.counts = {}
            for channel, time_ns, _ in messages_in(data):
                if channel in self.channels:
                    packed.count(channel, time_ns)
        return True

    def _take(self, opcode: int, content: bytes) -> None:
        with self.reading():
            stream = ReadDataStream(BytesIO(content))
            if opcode == Opcode.SCHEMA:
                schema = Schema.read(stream)
                self.schemas[schema.id] = schema
            elif opcode == Opcode.CHANNEL:
                channel = Channel.read(stream)
                self.channels[channel.id] = channel
            else:
                self._note_metadata(Metadata.read(stream))

    def _note_metadata(self, record: Metadata) -> None:
        text = record.metadata.get("serialized_metadata")
        if record.name == "rosbag2" and text:
            try:
                self.about = MetadataIo().deserialize_metadata(text)
            except RuntimeError:
                self.about = None  # it only repeats the records

    # -- bytes ---------------------------------------------------------------------------------------------------------

    def read(self, offset: int, length: int) -> bytes:
        """Read bytes; fewer at the end of the file."""
        if not 0 <= offset <= self.size:
            raise ValueError("its index is wrong")
        self.stream.seek(offset)
        return self.stream.read(min(length, self.size))

    def head(self, at: int) -> tuple[int, int] | None:
        """The opcode and length of the record at an offset; None if it isn't complete."""
        head = self.read(at, RECORD.size)
        if len(head) < RECORD.size:
            return None
        opcode, length = RECORD.unpack(head)
        return (opcode, length) if at + RECORD.size + length <= self.size else None

    def loose_message(self, at: int) -> Message:
        """Read a message outside of chunks, whose record is at an offset."""
        head = self.head(at)
        if head is None or head[0] != Opcode.MESSAGE:
            raise ValueError("its index is wrong")
        data = self.read(at + RECORD.size, head[1])
        channel, _, received, sent = MESSAGE_HEAD.unpack_from(data)
        return Message(received, sent, self.channels[channel].topic, data[MESSAGE_HEAD.size :])

    def unpack(self, offset: int, *, check: bool = False) -> bytes:
        """The records in a chunk. The last one is kept: messages beside each other are often wanted together."""
        if self._unpacked[0] == offset:
            return self._unpacked[1]
        with self.reading():
            head = self.head(offset)
            if head is None or head[0] != Opcode.CHUNK:
                raise ValueError("its index is wrong")
            chunk = Chunk.read(ReadDataStream(BytesIO(self.read(offset + RECORD.size, head[1]))))
            size = chunk.uncompressed_size
            if chunk.compression == "zstd":
                size = max(size, codec("zstd").frame_content_size(chunk.data))
            if size > _MOST_UNPACKED:
                raise ValueError(f"a chunk of {size} bytes")
            check_compression(chunk.compression)
            codec(chunk.compression)
            stream, length = get_chunk_data_stream(chunk, validate_crc=check)
            self._unpacked = (offset, stream.read(length))
        return self._unpacked[1]


class _Heads:
    """Reads a file from front to back, skipping what lies between the heads: by small pieces after a jump, then larger ones."""

    def __init__(self, file: McapFile) -> None:
        self._file = file
        self._begin = self._content = 0
        self._data = b""
        self._piece = _LEAST_PIECE

    def at(self, offset: int) -> tuple[int, int] | None:
        """The opcode of the record at an offset, and where it ends; None if it isn't complete, or can't be one."""
        here = offset - self._begin
        if here + _HEADS > len(self._data) and self._begin + len(self._data) < self._file.size:
            self._piece = min(4 * self._piece, _MOST_PIECE) if here <= len(self._data) else _LEAST_PIECE
            self._begin, self._data, here = offset, self._file.read(offset, self._piece), 0
        self._content = here + RECORD.size
        if self._content > len(self._data):
            return None
        opcode, length = RECORD.unpack_from(self._data, here)
        end = offset + RECORD.size + length
        return (opcode, end) if opcode and end <= self._file.size and length >= _SHORTEST.get(opcode, 0) else None

    def content(self, layout: struct.Struct) -> tuple[int, ...]:
        """The fields with which that record's content begins."""
        return layout.unpack_from(self._data, self._content)


def records(data: bytes) -> Iterator[tuple[int, int, int]]:
    """Opcode, begin and end of the contents of records that lie one behind the other."""
    at = 0
    while at + RECORD.size <= len(data):
        opcode, length = RECORD.unpack_from(data, at)
        at += RECORD.size
        if at + length > len(data):
            raise ValueError("a record is not complete")
        yield opcode, at, at + length
        at += length


def messages_in(data: bytes, base: int = 0) -> Iterator[tuple[int, int, int]]:
    """Channel, time and offset of the messages in an unpacked chunk, or of others that begin at `base`."""
    for opcode, begin, _ in records(data):
        if opcode == Opcode.MESSAGE:
            channel, _, time_ns, _ = MESSAGE_HEAD.unpack_from(data, begin)
            yield channel, time_ns, base + begin - RECORD.size


def check_compression(name: str) -> None:
    """Raise BadBag for a compression that no reader here knows."""
    if name not in COMPRESSIONS:
        raise BadBag(f"unsupported compression: {name}")


def _counts(index: ChunkIndex) -> dict[int, int]:
    """The number of a chunk's messages by channel, from the lengths of its message indexes."""
    ends = sorted(index.message_index_offsets.values())
    ends.append(_end_of(index))
    after = dict(pairwise(ends))
    head = RECORD.size + INDEX.size
    return {channel: (after[offset] - offset - head) // PAIR for channel, offset in index.message_index_offsets.items()}


def _end_of(index: ChunkIndex) -> int:
    return index.chunk_start_offset + index.chunk_length + index.message_index_length


def _topic_of(channel: Channel, schema: Schema | None) -> TopicMetadata:
    profiles: list[QoS] = []
    try:
        profiles = from_yaml(channel.metadata.get("offered_qos_profiles", ""))
    except ValueError:
        profiles = []  # written by a tool that stores something else there: treated as unknown
    return TopicMetadata(
        id=channel.id,
        name=channel.topic,
        type=schema.name if schema is not None else "",
        serialization_format=channel.message_encoding,
        offered_qos_profiles=profiles,
        type_description_hash=channel.metadata.get("topic_type_hash", ""),
    )
