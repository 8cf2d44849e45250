"""Reads MCAP files: by their index, or, when a file was cut off, record by record as far as it goes."""

from __future__ import annotations

import heapq
import zlib
from collections.abc import Callable, Iterator
from pathlib import Path
from typing import IO, NamedTuple

from rosbag2_py import _mcap_records as records
from rosbag2_py._compression import decompress
from rosbag2_py._mcap_records import BadBag, Channel, ChunkIndex, Schema
from rosbag2_py._metadata import MetadataIo
from rosbag2_py._qos import QoS, from_yaml
from rosbag2_py._storage import (
    BagMetadata,
    BagTime,
    Duration,
    FileInformation,
    MessageDefinition,
    TopicInformation,
    TopicMetadata,
)


class Message(NamedTuple):
    """A message of a bag: CDR bytes, and when it was received and sent (epoch nanoseconds; 0 is not known)."""

    received_ns: int
    sent_ns: int
    topic: str
    data: bytes


Wanted = Callable[[str], bool]


class McapReader:
    """One file. RuntimeError if it is no MCAP file at all."""

    storage_id = "mcap"

    def __init__(self, path: Path) -> None:
        self._path = path
        self._file: IO[bytes] = path.open("rb")
        self.schemas: dict[int, Schema] = {}
        self.channels: dict[int, Channel] = {}
        self._chunks: list[ChunkIndex] = []
        self._loose: list[tuple[int, int, int]] = []
        """(time, offset, length) of messages that are in no chunk."""
        self._counts: dict[int, int] = {}
        self._span: tuple[int, int] | None = None
        self._about: BagMetadata | None = None
        self.whole = True
        """Whether the file has its end; one that was cut off is read as far as it goes."""
        try:
            if self._file.read(len(records.MAGIC)) != records.MAGIC:
                raise BadBag(f"{path.name} is not an MCAP file")
            self._size = path.stat().st_size
            if not self._read_summary():
                self._scan()
        except BaseException:
            self._file.close()
            raise

    def close(self) -> None:
        self._file.close()

    # -- finding out what is there -------------------------------------------------------------------------------------

    def _read_summary(self) -> bool:
        """Read the index at the end; False if there is none, or one that does not say where messages are."""
        tail = records.FOOTER_SIZE + len(records.MAGIC)
        if self._size < tail + len(records.MAGIC):
            self.whole = False
            return False
        self._file.seek(self._size - tail)
        data = self._file.read(tail)
        if data[-len(records.MAGIC) :] != records.MAGIC or data[0] != records.FOOTER:
            self.whole = False
            return False
        start, _, _ = records.FOOTER_BODY.unpack_from(data, records.HEAD.size)
        if not 0 < start < self._size:
            return False
        statistics = None
        for kind, offset, length in self._records(start, self._size - tail):
            body = self._body(offset, length)
            if kind in (records.SCHEMA, records.CHANNEL):
                self._define(kind, body)
            elif kind == records.CHUNK_INDEX:
                self._chunks.append(records.read_chunk_index(body))
            elif kind == records.STATISTICS:
                statistics = records.read_statistics(body)
            elif kind == records.METADATA_INDEX:
                at, size = records.Body(body).number(8), records.Body(body[8:]).number(8)
                self._add_metadata(self._body(at + records.HEAD.size, size - records.HEAD.size))
        if statistics is None or (statistics.message_count and not self._chunks):
            self._forget()
            return False
        self._counts = statistics.counts
        self._span = (statistics.start_ns, statistics.end_ns) if statistics.message_count else None
        return True

    def _forget(self) -> None:
        self.schemas.clear()
        self.channels.clear()
        self._chunks.clear()

    def _records(self, start: int, end: int) -> Iterator[tuple[int, int, int]]:
        """Yield kind, offset and length of the content of the records between two places; stops at one that is cut off."""
        at = start
        while at + records.HEAD.size <= end:
            self._file.seek(at)
            kind, length = records.HEAD.unpack(self._file.read(records.HEAD.size))
            at += records.HEAD.size
            if at + length > end:
                return
            yield kind, at, length
            at += length

    def _body(self, offset: int, length: int) -> bytes:
        if offset < 0 or length < 0 or offset + length > self._size:
            raise BadBag(f"{self._path.name} is damaged: it names a place behind its end")
        self._file.seek(offset)
        return self._file.read(length)

    def _scan(self) -> None:
        """Go through the data from the beginning and note every chunk and message."""
        for kind, offset, length in self._records(len(records.MAGIC), self._size):
            if kind == records.CHUNK:
                if not self._scan_chunk(offset, length):
                    return
            elif kind == records.MESSAGE:
                channel, _, time, _ = records.MESSAGE_HEAD.unpack(self._body(offset, records.MESSAGE_HEAD.size))
                self._loose.append((time, offset, length))
                self._count(channel, time, time)
            elif kind == records.DATA_END:
                return
            else:
                self._take_definition(kind, offset, length)

    def _scan_chunk(self, offset: int, length: int) -> bool:
        """Note what is in a chunk; False if only a part of it was written."""
        body = self._body(offset, length)
        start, end, name, data = records.read_chunk(body)
        content = decompress(name, data)
        crc = records.chunk_crc(body)
        if crc and zlib.crc32(content) != crc:
            return False
        for kind, body in _split(content):
            if kind == records.MESSAGE:
                channel, _, time, _ = records.MESSAGE_HEAD.unpack_from(body)
                self._count(channel, time, time)
            else:
                self._define(kind, body)
        place = offset - records.HEAD.size
        self._chunks.append(ChunkIndex(start, end, place, length + records.HEAD.size, {}, 0, name, len(data), 0))
        return True

    def _take_definition(self, kind: int, offset: int, length: int) -> None:
        if kind in (records.SCHEMA, records.CHANNEL, records.METADATA):
            self._define(kind, self._body(offset, length))

    def _define(self, kind: int, body: bytes) -> None:
        if kind == records.SCHEMA:
            self._add_schema(body)
        elif kind == records.CHANNEL:
            self._add_channel(body)
        elif kind == records.METADATA:
            self._add_metadata(body)

    def _add_schema(self, body: bytes) -> None:
        schema = records.read_schema(body)
        self.schemas[schema.id] = schema

    def _add_channel(self, body: bytes) -> None:
        channel = records.read_channel(body)
        self.channels[channel.id] = channel

    def _add_metadata(self, body: bytes) -> None:
        name, values = records.read_metadata_record(body)
        text = values.get("serialized_metadata")
        if name == "rosbag2" and text:
            try:
                self._about = MetadataIo().deserialize_metadata(text)
            except RuntimeError:
                self._about = None  # it only repeats what the records say

    def _count(self, channel: int, first: int, last: int) -> None:
        self._counts[channel] = self._counts.get(channel, 0) + 1
        start, end = self._span or (first, last)
        self._span = (min(start, first), max(end, last))

    # -- what is known -------------------------------------------------------------------------------------------------

    def metadata(self) -> BagMetadata:
        """Describe the file alone, as if it were the whole bag."""
        start, end = self._span or (0, 0)
        count = sum(self._counts.values())
        counts: dict[str, int] = {}
        for id_, channel in self.channels.items():
            counts[channel.topic] = counts.get(channel.topic, 0) + self._counts.get(id_, 0)
        topics = {channel.topic: channel for channel in self.channels.values()}
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
                TopicInformation(self._topic(channel), counts[name]) for name, channel in topics.items()
            ],
            compression_mode="",
            custom_data=about.custom_data,
            ros_distro=about.ros_distro,
        )

    def _topic(self, channel: Channel) -> TopicMetadata:
        schema = self.schemas.get(channel.schema_id)
        profiles: list[QoS] = []
        try:
            profiles = from_yaml(channel.metadata.get("offered_qos_profiles", ""))
        except ValueError:
            profiles = []  # written by a tool that puts something else there: as if nothing were known
        return TopicMetadata(
            id=channel.id,
            name=channel.topic,
            type=schema.name if schema is not None else "",
            serialization_format=channel.encoding,
            offered_qos_profiles=profiles,
            type_description_hash=channel.metadata.get("topic_type_hash", ""),
        )

    def definitions(self) -> list[MessageDefinition]:
        """Return the texts of the message types."""
        return [
            MessageDefinition(each.name, each.encoding, each.data.decode("utf-8", "replace"), "")
            for each in self.schemas.values()
        ]

    # -- messages ------------------------------------------------------------------------------------------------------

    def messages(
        self, start_ns: int, wanted: Wanted, *, reverse: bool = False, by_file: bool = False
    ) -> Iterator[Message]:
        """Yield the messages from a time on (reverse: up to it), by time or as they lie in the file."""
        ids = {channel.id: channel.topic for channel in self.channels.values() if wanted(channel.topic)}
        loose = self._loose_messages(start_ns, ids, reverse=reverse, by_file=by_file)
        if by_file:
            yield from loose
            for index in sorted(self._chunks, key=lambda index: index.offset):
                for _, _, message in self._chunk_messages(index, start_ns, ids, reverse=False):
                    yield message
        else:
            packed = self._sorted_messages(start_ns, ids, reverse)
            yield from heapq.merge(loose, packed, key=lambda message: message.received_ns, reverse=reverse)

    def _sorted_messages(self, start_ns: int, ids: dict[int, str], reverse: bool) -> Iterator[Message]:
        """Merge chunks that overlap in time; no more of them are unpacked at once than overlap."""
        waiting: list[tuple[int, int, Message]] = []
        chunks = sorted(self._chunks, key=lambda index: -index.end_ns if reverse else index.start_ns)
        for index in chunks:
            edge = -index.end_ns if reverse else index.start_ns
            while waiting and waiting[0][0] < edge:
                yield heapq.heappop(waiting)[2]
            for entry in self._chunk_messages(index, start_ns, ids, reverse=reverse):
                heapq.heappush(waiting, entry)
        while waiting:
            yield heapq.heappop(waiting)[2]

    def _chunk_messages(
        self, index: ChunkIndex, start_ns: int, ids: dict[int, str], *, reverse: bool
    ) -> Iterator[tuple[int, int, Message]]:
        if (index.start_ns > start_ns) if reverse else (index.end_ns < start_ns):
            return
        head = records.HEAD.size
        _, _, name, data = records.read_chunk(self._body(index.offset + head, index.length - head))
        unpack, size = records.MESSAGE_HEAD.unpack_from, records.MESSAGE_HEAD.size
        for order, (kind, body) in enumerate(_split(decompress(name, data))):
            if kind != records.MESSAGE:
                continue
            channel, _, time, sent = unpack(body)
            topic = ids.get(channel)
            if topic is not None and (time <= start_ns if reverse else time >= start_ns):
                sign = -1 if reverse else 1
                yield sign * time, sign * (index.offset + order), Message(time, sent, topic, body[size:])

    def _loose_messages(self, start_ns: int, ids: dict[int, str], *, reverse: bool, by_file: bool) -> Iterator[Message]:
        entries = self._loose if by_file else sorted(self._loose, reverse=reverse)
        for time, offset, length in entries:
            if (time > start_ns) if reverse else (time < start_ns):
                continue
            body = self._body(offset, length)
            channel, _, _, sent = records.MESSAGE_HEAD.unpack_from(body)
            if channel in ids:
                yield Message(time, sent, ids[channel], body[records.MESSAGE_HEAD.size :])


def _split(data: bytes) -> Iterator[tuple[int, bytes]]:
    """Yield kind and content of the records in a chunk."""
    at = 0
    unpack, size = records.HEAD.unpack_from, records.HEAD.size
    while at + size <= len(data):
        kind, length = unpack(data, at)
        at += size
        yield kind, data[at : at + length]
        at += length
