"""Writes MCAP files that are complete at all times: each flush ends with the summary, which the next one overwrites.

So a killed recorder leaves a file that every reader opens; at most the messages since the last flush are missing. The mcap
library makes the records; its own writer appends the summary only once, at the end.
"""

from __future__ import annotations

import zlib
from contextlib import suppress
from pathlib import Path

from mcap.data_stream import RecordBuilder
from mcap.opcode import Opcode
from mcap.records import (
    Channel,
    Chunk,
    ChunkIndex,
    DataEnd,
    Footer,
    Header,
    McapRecord,
    Message,
    MessageIndex,
    Metadata,
    MetadataIndex,
    Schema,
    Statistics,
    SummaryOffset,
)

from rosbag2_py._compression import codec
from rosbag2_py._metadata import MetadataIo
from rosbag2_py._qos import yaml_lines
from rosbag2_py._storage import MCAP_MAGIC, BagMetadata, MessageDefinition, TopicMetadata

CHUNK_SIZE = 768 * 1024
"""Bytes of messages at which a chunk is closed (the default of the C++ library that rosbag2 uses)."""

LIBRARY = "day6-tui rosbag2_py"
_LEVELS = {"zstd_fast": 1, "zstd_small": 19}


def packed(*records: McapRecord) -> bytes:
    """Return records as bytes."""
    builder = RecordBuilder()
    for record in records:
        record.write(builder)
    data: bytes = builder.end()
    return data


class McapWriter:
    """One file: `create_topic`, `write`, `flush`, `close`. A preset of `MCAP_PRESETS` sets the compression of its chunks."""

    storage_id = "mcap"

    def __init__(self, path: Path, preset: str = "") -> None:
        level = _LEVELS.get(preset)
        self._compressor = codec("zstd").ZstdCompressor(level=level) if level is not None else None
        self._chunk_size = 4 * 1024 * 1024 if preset == "zstd_small" else CHUNK_SIZE
        self._file = path.open("xb", buffering=0)
        self._summary = b""
        """The bytes after the data, as they are in the file now."""
        self._failure: OSError | None = None
        """The error after which nothing more is written: the disk is full."""
        self._schemas: dict[str, Schema] = {}
        self._channels: dict[str, Channel] = {}
        self._unwritten: list[McapRecord] = []
        """Schemas and channels to write before the next message."""
        self._chunk = RecordBuilder()
        self._index: dict[int, MessageIndex] = {}
        """The index of the chunk: time and offset of each message, by channel id."""
        self._times: tuple[int, int] | None = None
        self._chunk_indexes: list[ChunkIndex] = []
        self._counts: dict[int, int] = {}
        self._span: tuple[int, int] | None = None
        self._end = 0
        """Offset at which the data ends and the summary begins."""
        self.metadata: BagMetadata | None = None
        """Written into the file at each flush, so that the file can be read without its folder."""
        self._append(MCAP_MAGIC + packed(Header("ros2", LIBRARY)))
        self._write_summary()

    @property
    def pieces(self) -> int:
        """The number of chunks: every flush rewrites an index entry for each."""
        return len(self._chunk_indexes)

    @property
    def size(self) -> int:
        """Bytes of data so far, including those not yet flushed."""
        return self._end + self._chunk.count

    def create_topic(self, topic: TopicMetadata, definition: MessageDefinition) -> None:
        """Add a topic; does nothing if it exists."""
        if topic.name in self._channels:
            return
        schema = self._schemas.get(topic.type)
        if schema is None:
            text = definition.encoded_message_definition.encode()
            schema = Schema(len(self._schemas) + 1, text, definition.encoding, topic.type)
            self._schemas[topic.type] = schema
            self._unwritten.append(schema)
        about = {
            "offered_qos_profiles": "\n".join(yaml_lines(topic.offered_qos_profiles)),
            "topic_type_hash": topic.type_description_hash,
        }
        channel = Channel(len(self._channels), topic.name, topic.serialization_format, about, schema.id)
        self._channels[topic.name] = channel
        self._unwritten.append(channel)

    def write(self, topic: str, data: bytes, received_ns: int, sent_ns: int) -> None:
        """Add a message.

        Raises:
            KeyError: the topic is unknown.
        """
        channel = self._channels[topic]
        chunk = self._chunk
        # In chunks too, so that a reader that scans the data meets a channel before its messages.
        for record in self._unwritten:
            record.write(chunk)
        self._unwritten.clear()
        index = self._index.get(channel.id)
        if index is None:
            index = self._index[channel.id] = MessageIndex(channel.id, [])
        index.records.append((received_ns, chunk.count))
        Message(channel.id, received_ns, data, sent_ns, 0).write(chunk)
        self._counts[channel.id] = self._counts.get(channel.id, 0) + 1
        first, last = self._times or (received_ns, received_ns)
        self._times = (min(first, received_ns), max(last, received_ns))
        if chunk.count >= self._chunk_size:
            self.flush()

    def flush(self) -> None:
        """Write everything to the disk, as a chunk with its index, followed by the summary.

        Raises:
            OSError: it does not fit; the file is then as it was before, and stays so.
        """
        if self._failure is not None:
            raise self._failure
        end, summary = self._end, self._summary
        try:
            if self._chunk.count:
                self._write_chunk()
            elif self._unwritten:
                self._append(packed(*self._unwritten))
                self._unwritten.clear()
            self._write_summary()
        except OSError as error:
            self._failure = error
            with suppress(OSError):  # there was room for it before
                self._put(end, summary)
                self._file.truncate()
            raise

    def close(self) -> None:
        """Flush for the last time, unless a flush has failed before, and close the file in any case.

        Raises:
            OSError: as in `flush`.
        """
        try:
            if not self._file.closed and self._failure is None:
                self.flush()
        finally:
            self._file.close()

    def _append(self, data: bytes) -> None:
        self._put(self._end, data)
        self._end += len(data)

    def _put(self, offset: int, data: bytes) -> None:
        self._file.seek(offset)
        rest = memoryview(data)
        while rest:
            rest = rest[self._file.write(rest) or 0 :]

    def _write_chunk(self) -> None:
        """Write the chunk with the index of its messages, and begin a new one."""
        content = self._chunk.end()
        data, name = content, ""
        if self._compressor is not None:
            data, name = self._compressor.compress(content), "zstd"
        first, last = self._times or (0, 0)
        parts = [packed(Chunk(name, data, last, first, zlib.crc32(content), len(content)))]
        chunk_length = at = len(parts[0])
        offsets: dict[int, int] = {}
        for channel, index in self._index.items():
            offsets[channel] = self._end + at
            parts.append(packed(index))
            at += len(parts[-1])
        chunk_start = self._end
        self._append(b"".join(parts))
        self._chunk_indexes.append(
            ChunkIndex(
                chunk_length=chunk_length,
                chunk_start_offset=chunk_start,
                compression=name,
                compressed_size=len(data),
                message_end_time=last,
                message_index_length=at - chunk_length,
                message_index_offsets=offsets,
                message_start_time=first,
                uncompressed_size=len(content),
            )
        )
        start, end = self._span or (first, last)
        self._span = (min(start, first), max(end, last))
        self._index.clear()
        self._times = None

    def _write_summary(self) -> None:
        """Write the summary after the data, without moving the end of the data."""
        metadata = b""
        if self.metadata is not None:
            about = {"serialized_metadata": MetadataIo().serialize_metadata(self.metadata)}
            metadata = packed(Metadata("rosbag2", about))
        head = metadata + packed(DataEnd(0))
        start = at = self._end + len(head)
        groups, offsets = b"", b""
        for kind, records in self._summary_groups(len(metadata)):
            group = packed(*records)
            if group:
                offsets += packed(SummaryOffset(kind, at, len(group)))
                groups += group
                at += len(group)
        body = groups + offsets
        crc = zlib.crc32(body + packed(Footer(start, at, 0))[:-4])
        self._summary = head + body + packed(Footer(start, at, crc)) + MCAP_MAGIC
        self._put(self._end, self._summary)
        self._file.truncate()

    def _summary_groups(self, metadata_length: int) -> list[tuple[Opcode, list[McapRecord]]]:
        first, last = self._span or (0, 0)
        statistics = Statistics(
            attachment_count=0,
            channel_count=len(self._channels),
            channel_message_counts=self._counts,
            chunk_count=len(self._chunk_indexes),
            message_count=sum(self._counts.values()),
            message_end_time=last,
            message_start_time=first,
            metadata_count=1 if metadata_length else 0,
            schema_count=len(self._schemas),
        )
        return [
            (Opcode.SCHEMA, [*self._schemas.values()]),
            (Opcode.CHANNEL, [*self._channels.values()]),
            (Opcode.STATISTICS, [statistics]),
            (Opcode.CHUNK_INDEX, [*self._chunk_indexes]),
            (Opcode.METADATA_INDEX, [MetadataIndex(self._end, metadata_length, "rosbag2")] if metadata_length else []),
        ]
