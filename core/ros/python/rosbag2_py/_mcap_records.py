"""The records of an MCAP file as bytes (https://mcap.dev/spec): a byte of kind, eight bytes of length, the content."""

from __future__ import annotations

import struct
from typing import NamedTuple

MAGIC = b"\x89MCAP0\r\n"

HEADER, FOOTER, SCHEMA, CHANNEL, MESSAGE, CHUNK, MESSAGE_INDEX, CHUNK_INDEX = range(1, 9)
STATISTICS, METADATA, METADATA_INDEX, SUMMARY_OFFSET, DATA_END = 0x0B, 0x0C, 0x0D, 0x0E, 0x0F

HEAD = struct.Struct("<BQ")
MESSAGE_HEAD = struct.Struct("<HIQQ")
FOOTER_BODY = struct.Struct("<QQI")
FOOTER_SIZE = HEAD.size + FOOTER_BODY.size
_PAIR = struct.Struct("<QQ")
_COUNT = struct.Struct("<HQ")


class BadBag(RuntimeError):
    """The file is not what its name says, or a part of it is damaged."""


class Schema(NamedTuple):
    """A message type: name, encoding of its text ('ros2msg'), the text."""

    id: int
    name: str
    encoding: str
    data: bytes


class Channel(NamedTuple):
    """A topic."""

    id: int
    schema_id: int
    topic: str
    encoding: str
    metadata: dict[str, str]


class ChunkIndex(NamedTuple):
    """Where a chunk lies (offset and length in the file), and the times of its messages in nanoseconds."""

    start_ns: int
    end_ns: int
    offset: int
    length: int
    index_offsets: dict[int, int]
    index_length: int
    compression: str
    compressed_size: int
    size: int


class Statistics(NamedTuple):
    """Counts of a whole file; `counts` by channel id."""

    message_count: int
    schema_count: int
    channel_count: int
    metadata_count: int
    chunk_count: int
    start_ns: int
    end_ns: int
    counts: dict[int, int]


# -- writing -----------------------------------------------------------------------------------------------------------


def record(kind: int, body: bytes) -> bytes:
    """Return a whole record."""
    return HEAD.pack(kind, len(body)) + body


def text(value: str) -> bytes:
    """Return a string with its length."""
    data = value.encode()
    return len(data).to_bytes(4, "little") + data


def text_map(values: dict[str, str]) -> bytes:
    """Return a map of strings with its length in bytes."""
    body = b"".join(text(key) + text(value) for key, value in values.items())
    return len(body).to_bytes(4, "little") + body


def _number_map(values: dict[int, int]) -> bytes:
    body = b"".join(_COUNT.pack(key, value) for key, value in values.items())
    return len(body).to_bytes(4, "little") + body


def schema_record(schema: Schema) -> bytes:
    """The text of a message type."""
    head = schema.id.to_bytes(2, "little") + text(schema.name) + text(schema.encoding)
    return record(SCHEMA, head + len(schema.data).to_bytes(4, "little") + schema.data)


def channel_record(channel: Channel) -> bytes:
    """A topic: its type, its QoS among the metadata."""
    body = struct.pack("<HH", channel.id, channel.schema_id) + text(channel.topic) + text(channel.encoding)
    return record(CHANNEL, body + text_map(channel.metadata))


def message_index_record(channel_id: int, entries: list[tuple[int, int]]) -> bytes:
    """`entries`: time and offset in the unpacked chunk of each message."""
    packed = b"".join(_PAIR.pack(*entry) for entry in entries)
    return record(MESSAGE_INDEX, struct.pack("<HI", channel_id, len(packed)) + packed)


def chunk_record(start_ns: int, end_ns: int, size: int, crc: int, compression: str, data: bytes) -> bytes:
    """Packed records; `size` and `crc` are those of the unpacked ones."""
    body = struct.pack("<QQQI", start_ns, end_ns, size, crc) + text(compression) + len(data).to_bytes(8, "little")
    return record(CHUNK, body + data)


def chunk_index_record(index: ChunkIndex) -> bytes:
    """Where a chunk is and what is in it."""
    body = struct.pack("<QQQQ", index.start_ns, index.end_ns, index.offset, index.length)
    body += _number_map(index.index_offsets) + index.index_length.to_bytes(8, "little") + text(index.compression)
    return record(CHUNK_INDEX, body + _PAIR.pack(index.compressed_size, index.size))


def statistics_record(found: Statistics) -> bytes:
    """Counts and times of the whole file."""
    body = struct.pack("<QHIIII", *found[:3], 0, *found[3:5])
    return record(STATISTICS, body + _PAIR.pack(found.start_ns, found.end_ns) + _number_map(found.counts))


def metadata_record(name: str, values: dict[str, str]) -> bytes:
    """Named texts."""
    return record(METADATA, text(name) + text_map(values))


def metadata_index_record(offset: int, length: int, name: str) -> bytes:
    """Where a metadata record is."""
    return record(METADATA_INDEX, _PAIR.pack(offset, length) + text(name))


def summary_offset_record(kind: int, start: int, length: int) -> bytes:
    """Where the records of one kind are in the summary."""
    return record(SUMMARY_OFFSET, struct.pack("<BQQ", kind, start, length))


# -- reading -----------------------------------------------------------------------------------------------------------


class Body:
    """Takes values from the content of a record, one after the other. BadBag when it is shorter than it says."""

    def __init__(self, data: bytes) -> None:
        self.data = data
        self.at = 0

    def take(self, size: int) -> bytes:
        end = self.at + size
        if end > len(self.data):
            raise BadBag("a record is shorter than it says")
        part, self.at = self.data[self.at : end], end
        return part

    def number(self, size: int) -> int:
        return int.from_bytes(self.take(size), "little")

    def text(self) -> str:
        return self.take(self.number(4)).decode("utf-8", "replace")

    def text_map(self) -> dict[str, str]:
        inner = Body(self.take(self.number(4)))
        found = {}
        while inner.at < len(inner.data):
            key = inner.text()
            found[key] = inner.text()
        return found

    def number_map(self) -> dict[int, int]:
        return dict(_COUNT.iter_unpack(self.whole(self.take(self.number(4)), _COUNT.size)))

    @staticmethod
    def whole(data: bytes, size: int) -> bytes:
        return data[: len(data) // size * size]


def read_schema(data: bytes) -> Schema:
    """Read what `schema_record` writes."""
    body = Body(data)
    return Schema(body.number(2), body.text(), body.text(), body.take(body.number(4)))


def read_channel(data: bytes) -> Channel:
    """Read what `channel_record` writes."""
    body = Body(data)
    return Channel(body.number(2), body.number(2), body.text(), body.text(), body.text_map())


def read_chunk_index(data: bytes) -> ChunkIndex:
    """Read what `chunk_index_record` writes."""
    body = Body(data)
    start, end, offset, length = (body.number(8) for _ in range(4))
    offsets, index_length, compression = body.number_map(), body.number(8), body.text()
    return ChunkIndex(start, end, offset, length, offsets, index_length, compression, body.number(8), body.number(8))


def read_statistics(data: bytes) -> Statistics:
    """Read what `statistics_record` writes."""
    body = Body(data)
    messages, schemas, channels = body.number(8), body.number(2), body.number(4)
    body.number(4)
    metadata, chunks, start, end = body.number(4), body.number(4), body.number(8), body.number(8)
    return Statistics(messages, schemas, channels, metadata, chunks, start, end, body.number_map())


def read_chunk(data: bytes) -> tuple[int, int, str, bytes]:
    """Return start and end time, compression, and the records as they lie there."""
    body = Body(data)
    start, end, _, _ = body.number(8), body.number(8), body.number(8), body.number(4)
    return start, end, body.text(), body.take(body.number(8))


def chunk_crc(data: bytes) -> int:
    """Return the checksum of a chunk's unpacked records, 0 if it has none."""
    return int.from_bytes(data[24:28], "little")


def read_metadata_record(data: bytes) -> tuple[str, dict[str, str]]:
    """Return the name and the texts."""
    body = Body(data)
    return body.text(), body.text_map()
