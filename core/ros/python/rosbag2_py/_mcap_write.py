"""Writes MCAP files that are whole at every moment: each flush ends with the summary, which the next one overwrites.

So a recorder that is killed leaves a file that every reader opens; at most the messages since the last flush are missing.
"""

from __future__ import annotations

import zlib
from contextlib import suppress
from pathlib import Path

from rosbag2_py import _mcap_records as records
from rosbag2_py._compression import zstd_codec
from rosbag2_py._mcap_records import Channel, ChunkIndex, Schema, Statistics
from rosbag2_py._metadata import MetadataIo
from rosbag2_py._qos import yaml_lines
from rosbag2_py._storage import BagMetadata, MessageDefinition, TopicMetadata

CHUNK_SIZE = 768 * 1024
"""Bytes of messages from which a chunk is closed (the default of the C++ library that rosbag2 uses)."""

LIBRARY = "day6-tui rosbag2_py"
SUFFIX = ".mcap"
PRESETS = {
    "none": "Default profile, no special settings.",
    "fastwrite": "Disables CRC and chunking for faster writing.",
    "zstd_fast": "Use Zstd chunk compression on Fastest level.",
    "zstd_small": "Use Zstd chunk compression on Slowest level, for smallest file size.",
}
_LEVELS = {"zstd_fast": 1, "zstd_small": 19}


class McapWriter:
    """One file. `create_topic`, `write`, `flush`, `close`; a preset of `PRESETS` chooses the compression of its chunks."""

    storage_id = "mcap"

    def __init__(self, path: Path, preset: str = "") -> None:
        self._level = _LEVELS.get(preset)
        self._compress = zstd_codec()[0] if self._level is not None else None
        self._chunk_size = 4 * 1024 * 1024 if preset == "zstd_small" else CHUNK_SIZE
        self._file = path.open("xb", buffering=0)
        self._summary = b""
        """What stands behind the data now."""
        self._failure: OSError | None = None
        """Why nothing more is written: the disk is full."""
        self._schemas: dict[str, Schema] = {}
        self._channels: dict[str, Channel] = {}
        self._unwritten: list[bytes] = []
        self._chunk = bytearray()
        self._index: dict[int, list[tuple[int, int]]] = {}
        self._times: tuple[int, int] | None = None
        self._chunk_indexes: list[bytes] = []
        self._counts: dict[int, int] = {}
        self._span: tuple[int, int] | None = None
        self._end = 0
        """Where the data ends and the summary begins."""
        self.metadata: BagMetadata | None = None
        """Written into the file at each flush, so that it can be understood without its folder."""
        self._append(records.MAGIC + records.record(records.HEADER, records.text("ros2") + records.text(LIBRARY)))
        self._write_summary()

    @property
    def pieces(self) -> int:
        """How many chunks there are: every flush writes as many lines of index again."""
        return len(self._chunk_indexes)

    @property
    def size(self) -> int:
        """Bytes of data so far, those not yet flushed included."""
        return self._end + len(self._chunk)

    def create_topic(self, topic: TopicMetadata, definition: MessageDefinition) -> None:
        """Make a topic known; a second time does nothing."""
        if topic.name in self._channels:
            return
        schema = self._schemas.get(topic.type)
        if schema is None:
            data = definition.encoded_message_definition.encode()
            schema = Schema(len(self._schemas) + 1, topic.type, definition.encoding, data)
            self._schemas[topic.type] = schema
            self._unwritten.append(records.schema_record(schema))
        about = {
            "offered_qos_profiles": "\n".join(yaml_lines(topic.offered_qos_profiles)),
            "topic_type_hash": topic.type_description_hash,
        }
        channel = Channel(len(self._channels), schema.id, topic.name, topic.serialization_format, about)
        self._channels[topic.name] = channel
        self._unwritten.append(records.channel_record(channel))

    def write(self, topic: str, data: bytes, received_ns: int, sent_ns: int) -> None:
        """Add a message. KeyError for an unknown topic."""
        channel = self._channels[topic]
        chunk = self._chunk
        if self._unwritten:
            # Inside of chunks too, so that a reader that goes through the data meets a channel before its messages.
            chunk += b"".join(self._unwritten)
            self._unwritten.clear()
        self._index.setdefault(channel.id, []).append((received_ns, len(chunk)))
        chunk += records.HEAD.pack(records.MESSAGE, records.MESSAGE_HEAD.size + len(data))
        chunk += records.MESSAGE_HEAD.pack(channel.id, 0, received_ns, sent_ns)
        chunk += data
        self._counts[channel.id] = self._counts.get(channel.id, 0) + 1
        first, last = self._times or (received_ns, received_ns)
        self._times = (min(first, received_ns), max(last, received_ns))
        if len(chunk) >= self._chunk_size:
            self.flush()

    def flush(self) -> None:
        """Put everything on the disk, as a chunk with its index, and the summary behind it.

        Raises OSError when it does not fit; the file then is as it was before, and stays so.
        """
        if self._failure is not None:
            raise self._failure
        end, summary = self._end, self._summary
        try:
            if self._chunk:
                self._write_chunk()
            elif self._unwritten:
                self._append(b"".join(self._unwritten))
                self._unwritten.clear()
            self._write_summary()
        except OSError as error:
            self._failure = error
            with suppress(OSError):  # it had its place there already
                self._put(end, summary)
                self._file.truncate()
            raise

    def close(self) -> None:
        """Flush for the last time, unless that has failed before. Raises OSError as `flush`; closed it is in any case."""
        try:
            if not self._file.closed and self._failure is None:
                self.flush()
        finally:
            self._file.close()

    def _append(self, data: bytes) -> None:
        self._put(self._end, data)
        self._end += len(data)

    def _put(self, place: int, data: bytes) -> None:
        self._file.seek(place)
        rest = memoryview(data)
        while rest:
            rest = rest[self._file.write(rest) or 0 :]

    def _write_chunk(self) -> None:
        data, crc, name = bytes(self._chunk), zlib.crc32(self._chunk), ""
        size = len(data)
        if self._compress is not None and self._level is not None:
            data, name = self._compress(data, self._level), "zstd"
        first, last = self._times or (0, 0)
        chunk = records.chunk_record(first, last, size, crc, name, data)
        offset = self._end
        offsets: dict[int, int] = {}
        parts = [chunk]
        at = offset + len(chunk)
        for channel, entries in self._index.items():
            offsets[channel] = at
            parts.append(records.message_index_record(channel, entries))
            at += len(parts[-1])
        index_length = at - offset - len(chunk)
        self._append(b"".join(parts))
        found = ChunkIndex(first, last, offset, len(chunk), offsets, index_length, name, len(data), size)
        self._chunk_indexes.append(records.chunk_index_record(found))
        start, end = self._span or (first, last)
        self._span = (min(start, first), max(end, last))
        self._chunk.clear()
        self._index.clear()
        self._times = None

    def _write_summary(self) -> None:
        """Write what stands behind the data, without moving the place where the next data go."""
        start = self._end
        parts: list[bytes] = []
        metadata = b""
        if self.metadata is not None:
            about = {"serialized_metadata": MetadataIo().serialize_metadata(self.metadata)}
            metadata = records.metadata_record("rosbag2", about)
        parts += [metadata, records.record(records.DATA_END, b"\0\0\0\0")]
        summary_start = at = start + sum(map(len, parts))
        summary = b""
        offsets = b""
        for kind, group in self._summary_groups(start, metadata):
            if group:
                offsets += records.summary_offset_record(kind, at, len(group))
                summary += group
                at += len(group)
        footer = records.HEAD.pack(records.FOOTER, records.FOOTER_BODY.size) + records.FOOTER_BODY.pack(
            summary_start, at, 0
        )
        crc = zlib.crc32(summary + offsets + footer[:-4])
        parts += [summary, offsets, footer[:-4], crc.to_bytes(4, "little"), records.MAGIC]
        summary = b"".join(parts)
        self._put(start, summary)
        self._file.truncate()
        self._summary = summary

    def _summary_groups(self, metadata_at: int, metadata: bytes) -> list[tuple[int, bytes]]:
        first, last = self._span or (0, 0)
        total = Statistics(
            sum(self._counts.values()),
            len(self._schemas),
            len(self._channels),
            1 if metadata else 0,
            len(self._chunk_indexes),
            first,
            last,
            self._counts,
        )
        index = records.metadata_index_record(metadata_at, len(metadata), "rosbag2") if metadata else b""
        return [
            (records.SCHEMA, b"".join(map(records.schema_record, self._schemas.values()))),
            (records.CHANNEL, b"".join(map(records.channel_record, self._channels.values()))),
            (records.STATISTICS, records.statistics_record(total)),
            (records.CHUNK_INDEX, b"".join(self._chunk_indexes)),
            (records.METADATA_INDEX, index),
        ]
