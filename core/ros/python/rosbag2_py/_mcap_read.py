"""Reads MCAP files with the mcap library: by their index, or, if a file was cut off, record by record as far as it goes."""

from __future__ import annotations

import heapq
import struct
from collections.abc import Iterator
from contextlib import contextmanager
from dataclasses import dataclass, field
from operator import attrgetter
from pathlib import Path
from typing import IO

from mcap.exceptions import McapError
from mcap.reader import SeekingReader
from mcap.records import Channel, Chunk, ChunkIndex, DataEnd, McapRecord, Metadata, Schema
from mcap.records import Message as Record
from mcap.stream_reader import StreamReader, breakup_chunk
from mcap.summary import Summary
from zstandard import ZstdError

from rosbag2_py._metadata import MetadataIo
from rosbag2_py._qos import QoS, from_yaml
from rosbag2_py._storage import (
    MCAP_MAGIC,
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

COMPRESSIONS = {"", "zstd", "lz4"}
"""The formats of compressed chunks; the library treats any other as not compressed."""
DAMAGE = (McapError, ZstdError, RuntimeError, struct.error, ValueError, LookupError, OverflowError, MemoryError)
"""The errors that the library raises for damaged bytes; lz4 raises RuntimeError."""
_HEAD = 9
"""Bytes before a record's content: its opcode and its length."""
MESSAGE_HEAD = struct.Struct("<HIQQ")
"""The fields before a message's data: channel, sequence number, time received, time sent."""


@dataclass
class _Contents:
    """The contents of a file: the library's summary, and what the library does not keep."""

    summary: Summary = field(default_factory=Summary)
    counts: dict[int, int] = field(default_factory=dict)
    """Messages by channel id."""
    first_ns: int = 0
    last_ns: int = 0
    loose: list[tuple[int, int, int]] = field(default_factory=list)
    """(time, offset of the data, their length) of messages outside of chunks."""

    def count(self, channel: int, time_ns: int) -> None:
        self.first_ns = min(self.first_ns, time_ns) if self.counts else time_ns
        self.last_ns = max(self.last_ns, time_ns)
        self.counts[channel] = self.counts.get(channel, 0) + 1


class _Indexed(SeekingReader):
    """Reads messages by an index, from the file or built by us."""

    def __init__(self, stream: IO[bytes], summary: Summary) -> None:
        stream.seek(0)
        super().__init__(stream)
        self.contents = summary

    def get_summary(self) -> Summary:
        return self.contents


class McapReader:
    """One file.

    Raises:
        RuntimeError: it isn't an MCAP file, or it can't be read.
    """

    storage_id = "mcap"

    def __init__(self, path: Path) -> None:
        self._path = path
        self._file: IO[bytes] = path.open("rb")
        self._about: BagMetadata | None = None
        self.is_complete = True
        """Whether the file is complete; one that was cut off is read as far as it goes."""
        try:
            if self._file.read(len(MCAP_MAGIC)) != MCAP_MAGIC:
                raise BadBag(f"{path.name} is not an MCAP file")
            self._size = path.stat().st_size
            self._contents = self._by_index() or self._by_scanning()
            for index in self._contents.summary.chunk_indexes:
                if index.compression not in COMPRESSIONS:
                    raise BadBag(f"unsupported compression: {index.compression}")
        except BaseException:
            self._file.close()
            raise

    def close(self) -> None:
        self._file.close()

    # -- index ---------------------------------------------------------------------------------------------------------

    def _by_index(self) -> _Contents | None:
        """Read the index at the end; returns None if it is missing or doesn't list the chunks."""
        self._file.seek(-len(MCAP_MAGIC), 2)
        if self._file.tell() == 0 or self._file.read() != MCAP_MAGIC:
            self.is_complete = False
            return None
        self._file.seek(0)
        reader = SeekingReader(self._file, record_size_limit=self._size)
        try:
            summary = reader.get_summary()
            if summary is None or summary.statistics is None:
                return None
            for metadata in reader.iter_metadata():
                self._add_metadata(metadata)
        except (*DAMAGE, OSError):  # its offsets may be impossible
            return None  # the messages themselves may be intact
        found = summary.statistics
        if found.message_count and not summary.chunk_indexes:
            return None
        if any(index.chunk_start_offset + index.chunk_length > self._size for index in summary.chunk_indexes):
            return None
        return _Contents(summary, found.channel_message_counts, found.message_start_time, found.message_end_time)

    def _by_scanning(self) -> _Contents:
        """Scan the data from the beginning and index every chunk and message."""
        found = _Contents()
        for record in self._records():
            if isinstance(record, DataEnd):
                break
            if not isinstance(record, Chunk):
                self._note(record, found)
                if isinstance(record, Record):
                    found.loose.append((record.log_time, self._file.tell() - len(record.data), len(record.data)))
                continue
            try:
                inside = breakup_chunk(record, validate_crc=True)
            except DAMAGE:
                break  # it was written only in part
            found.summary.chunk_indexes.append(self._index_of(record))
            for each in inside:
                self._note(each, found)
        return found

    def _records(self) -> Iterator[McapRecord]:
        """Yield the records, with chunks unopened; ends where the file was cut off or is damaged."""
        self._file.seek(len(MCAP_MAGIC))
        stream = StreamReader(self._file, skip_magic=True, emit_chunks=True, record_size_limit=self._size)
        try:
            yield from stream.records
        except DAMAGE:
            self.is_complete = False

    def _index_of(self, chunk: Chunk) -> ChunkIndex:
        """Return the index record of the chunk that was just read."""
        length = _HEAD + 8 + 8 + 8 + 4 + 4 + len(chunk.compression.encode()) + 8 + len(chunk.data)
        return ChunkIndex(
            chunk_length=length,
            chunk_start_offset=self._file.tell() - length,
            compression=chunk.compression,
            compressed_size=len(chunk.data),
            message_end_time=chunk.message_end_time,
            message_index_length=0,
            message_index_offsets={},
            message_start_time=chunk.message_start_time,
            uncompressed_size=chunk.uncompressed_size,
        )

    def _note(self, record: McapRecord, found: _Contents) -> None:
        if isinstance(record, Schema):
            found.summary.schemas[record.id] = record
        elif isinstance(record, Channel):
            found.summary.channels[record.id] = record
        elif isinstance(record, Metadata):
            self._add_metadata(record)
        elif isinstance(record, Record):
            found.count(record.channel_id, record.log_time)

    def _add_metadata(self, record: Metadata) -> None:
        text = record.metadata.get("serialized_metadata")
        if record.name == "rosbag2" and text:
            try:
                self._about = MetadataIo().deserialize_metadata(text)
            except RuntimeError:
                self._about = None  # it only repeats the records

    # -- metadata ------------------------------------------------------------------------------------------------------

    def metadata(self) -> BagMetadata:
        """Return the metadata of the file alone, as if it were the whole bag."""
        found = self._contents
        start, end = (found.first_ns, found.last_ns) if found.counts else (0, 0)
        count = sum(found.counts.values())
        channels = found.summary.channels
        counts: dict[str, int] = {}
        for id_, channel in channels.items():
            counts[channel.topic] = counts.get(channel.topic, 0) + found.counts.get(id_, 0)
        topics = {channel.topic: channel for channel in channels.values()}
        about = self._about or BagMetadata()
        return BagMetadata(
            bag_size=self._size,
            storage_identifier=self.storage_id,
            relative_file_paths=[self._path.name],
            files=[FileInformation(self._path.name, BagTime(start), Duration(0, end - start), count)],
            duration=Duration(0, end - start),
            starting_time=BagTime(start),
            message_count=count,
            topics_with_message_count=[
                TopicInformation(topic_of(channel, found.summary.schemas.get(channel.schema_id)), counts[name])
                for name, channel in topics.items()
            ],
            compression_mode="",
            custom_data=about.custom_data,
            ros_distro=about.ros_distro,
        )

    def definitions(self) -> list[MessageDefinition]:
        """Return the texts of the message types."""
        return [definition_of(each) for each in self._contents.summary.schemas.values()]

    # -- messages ------------------------------------------------------------------------------------------------------

    def messages(
        self, start_ns: int, wanted: Wanted, *, reverse: bool = False, by_file: bool = False
    ) -> Iterator[Message]:
        """Yield the messages from a time on (reverse: up to it), by time or in the file's order.

        Raises:
            BadBag: the file is damaged, from there on.
        """
        topics = {channel.topic for channel in self._contents.summary.channels.values() if wanted(channel.topic)}
        with self._named():
            loose = self._loose_messages(start_ns, topics, reverse=reverse, by_file=by_file)
            packed = self._packed_messages(start_ns, topics, reverse=reverse, by_file=by_file)
            if by_file:
                yield from loose
                yield from packed
            else:
                yield from heapq.merge(loose, packed, key=attrgetter("received_ns"), reverse=reverse)

    @contextmanager
    def _named(self) -> Iterator[None]:
        """Turn the library's errors for damaged bytes into a BadBag that names the file."""
        try:
            yield
        except DAMAGE as error:
            raise BadBag(f"{self._path.name} is damaged: {error or type(error).__name__}") from error

    def _packed_messages(self, start_ns: int, topics: set[str], *, reverse: bool, by_file: bool) -> Iterator[Message]:
        summary = self._contents.summary
        if not summary.chunk_indexes:
            return  # the library would scan the whole file
        bounds = {"ending_at": start_ns} if reverse else {"starting_at": start_ns}
        reader = _Indexed(self._file, summary)
        for _, channel, record in reader.iter_messages(topics, log_time_order=not by_file, reverse=reverse, **bounds):
            yield Message(record.log_time, record.publish_time, channel.topic, record.data)

    def _loose_messages(self, start_ns: int, topics: set[str], *, reverse: bool, by_file: bool) -> Iterator[Message]:
        found = self._contents
        for time_ns, offset, length in found.loose if by_file else sorted(found.loose, reverse=reverse):
            if (time_ns > start_ns) if reverse else (time_ns < start_ns):
                continue
            self._file.seek(offset - MESSAGE_HEAD.size)
            channel_id, _, _, sent_ns = MESSAGE_HEAD.unpack(self._file.read(MESSAGE_HEAD.size))
            channel = found.summary.channels.get(channel_id)
            if channel is not None and channel.topic in topics:
                yield Message(time_ns, sent_ns, channel.topic, self._file.read(length))


def topic_of(channel: Channel, schema: Schema | None) -> TopicMetadata:
    """Return what a channel tells of its topic."""
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


def definition_of(schema: Schema) -> MessageDefinition:
    """Return the text of a message type."""
    return MessageDefinition(schema.name, schema.encoding, schema.data.decode("utf-8", "replace"), "")
