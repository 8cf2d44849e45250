"""Reads MCAP files with the mcap library: by their index, or, if a file was cut off, as far as it goes."""

from __future__ import annotations

import heapq
from array import array
from collections.abc import Iterator
from dataclasses import dataclass, field
from operator import attrgetter
from pathlib import Path

from mcap.reader import SeekingReader
from mcap.records import ChunkIndex
from mcap.summary import Summary

from rosbag2_py._compression import codec
from rosbag2_py._mcap_file import McapFile, check_compression
from rosbag2_py._storage import (
    BagMetadata,
    BagTime,
    Duration,
    FileInformation,
    Message,
    MessageDefinition,
    TopicInformation,
    Wanted,
)


@dataclass
class _Contents:
    """Where a file's messages are, and how many there are."""

    chunks: list[ChunkIndex] = field(default_factory=list)
    times: array[int] = field(default_factory=lambda: array("q"))
    places: array[int] = field(default_factory=lambda: array("q"))
    """Times, and offsets of the records, of messages outside of chunks."""
    counts: dict[int, int] = field(default_factory=dict)
    """Messages by channel."""
    start_ns: int = 0
    end_ns: int = 0


class _Indexed(SeekingReader):
    """Reads messages by an index, from the file or built by us."""

    def __init__(self, file: McapFile, chunks: list[ChunkIndex]) -> None:
        file.stream.seek(0)
        super().__init__(file.stream)
        self.contents = Summary()
        self.contents.schemas, self.contents.channels = file.schemas, file.channels
        self.contents.chunk_indexes = chunks

    def get_summary(self) -> Summary:
        return self.contents


class McapReader:
    """One file.

    Raises:
        RuntimeError: it isn't an MCAP file, or it can't be read.
    """

    storage_id = "mcap"

    def __init__(self, path: Path) -> None:
        self._file = McapFile(path)
        self._path = path
        try:
            self._contents = self._find()
        except BaseException:
            self._file.close()
            raise
        summary = self._file.summary
        self.has_time_order = summary is not None and any(index.message_index_length for index in summary.chunk_indexes)
        """Whether the file tells the order of time: real ROS plays a file that doesn't as it was written."""

    def close(self) -> None:
        self._file.close()

    def _find(self) -> _Contents:
        summary = self._file.summary
        known = summary.statistics if summary is not None else None
        if summary is not None and known is not None and (summary.chunk_indexes or not known.message_count):
            for index in summary.chunk_indexes:
                check_compression(index.compression)
            counts, start, end = known.channel_message_counts, known.message_start_time, known.message_end_time
            return _Contents(summary.chunk_indexes, counts=counts, start_ns=start, end_ns=end)
        found = _Contents()
        for stretch in self._file.stretches():
            if stretch.chunk is not None:
                found.chunks.append(stretch.chunk)
            found.times += stretch.times
            found.places += stretch.places
            if stretch.counts:
                found.start_ns = min(found.start_ns, stretch.start_ns) if found.counts else stretch.start_ns
                found.end_ns = max(found.end_ns, stretch.end_ns)
            for channel, count in stretch.counts.items():
                found.counts[channel] = found.counts.get(channel, 0) + count
        return found

    # -- metadata ------------------------------------------------------------------------------------------------------

    def metadata(self) -> BagMetadata:
        """Return the metadata of the file alone, as if it were the whole bag."""
        found, file = self._contents, self._file
        count = sum(found.counts.values())
        counts: dict[str, int] = {}
        for id_, channel in file.channels.items():
            counts[channel.topic] = counts.get(channel.topic, 0) + found.counts.get(id_, 0)
        about = file.about or BagMetadata()
        duration = Duration(0, found.end_ns - found.start_ns)
        return BagMetadata(
            bag_size=file.size,
            storage_identifier=self.storage_id,
            relative_file_paths=[self._path.name],
            files=[FileInformation(self._path.name, BagTime(found.start_ns), duration, count)],
            duration=duration,
            starting_time=BagTime(found.start_ns),
            message_count=count,
            topics_with_message_count=[TopicInformation(topic, counts[topic.name]) for topic in file.topics()],
            compression_mode="",
            custom_data=about.custom_data,
            ros_distro=about.ros_distro,
        )

    def definitions(self) -> list[MessageDefinition]:
        """Return the texts of the message types."""
        return self._file.definitions()

    # -- messages ------------------------------------------------------------------------------------------------------

    def messages(
        self, start_ns: int, wanted: Wanted, *, reverse: bool = False, by_file: bool = False
    ) -> Iterator[Message]:
        """Yield the messages from a time on (reverse: up to it), by time or in the file's order.

        Raises:
            BadBag: the file is damaged, from there on.
            MissingCodec: its chunks are compressed, and what unpacks them isn't installed.
        """
        topics = {channel.topic for channel in self._file.channels.values() if wanted(channel.topic)}
        for compression in {chunk.compression for chunk in self._contents.chunks}:
            codec(compression)  # the library would not say which package it lacks
        with self._file.reading():
            loose = self._loose_messages(start_ns, topics, reverse=reverse, by_file=by_file)
            packed = self._packed_messages(start_ns, topics, reverse=reverse, by_file=by_file)
            if by_file:
                yield from loose
                yield from packed
            else:
                yield from heapq.merge(loose, packed, key=attrgetter("received_ns"), reverse=reverse)

    def _packed_messages(self, start_ns: int, topics: set[str], *, reverse: bool, by_file: bool) -> Iterator[Message]:
        chunks = self._contents.chunks
        if not chunks:
            return  # the library would scan the whole file
        bounds = {"ending_at": start_ns} if reverse else {"starting_at": start_ns}
        reader = _Indexed(self._file, chunks)
        for _, channel, record in reader.iter_messages(topics, log_time_order=not by_file, reverse=reverse, **bounds):
            yield Message(record.log_time, record.publish_time, channel.topic, record.data)

    def _loose_messages(self, start_ns: int, topics: set[str], *, reverse: bool, by_file: bool) -> Iterator[Message]:
        times, places = self._contents.times, self._contents.places
        order = range(len(times))
        for number in order if by_file else sorted(order, key=times.__getitem__, reverse=reverse):
            if (times[number] > start_ns) if reverse else (times[number] < start_ns):
                continue
            message = self._file.loose_message(places[number])
            if message.topic in topics:
                yield message
