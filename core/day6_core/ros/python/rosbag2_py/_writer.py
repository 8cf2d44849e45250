"""`SequentialWriter`: a bag of one file or several, complete on the disk after every second."""

from __future__ import annotations

import os
import re
import time
import weakref
from collections import Counter
from collections.abc import Callable, Iterator
from contextlib import contextmanager, suppress
from pathlib import Path

from day6_core.ros.differences import value
from day6_core.whole_file import replace_file
from rosbag2_py._compression import (
    CompressionMode,
    CompressionOptions,
    codec,
    get_registered_compressors,
    zstd_compress,
)
from rosbag2_py._console import Log, to_console
from rosbag2_py._definitions import LocalMessageDefinitionSource
from rosbag2_py._files import (
    MINIMUM_SPLIT,
    SUFFIXES,
    BagWriter,
    create_file,
    get_registered_serializers,
    get_registered_writers,
    presets,
)
from rosbag2_py._kept_messages import SECOND, Kept, LastMessages, LastMoments
from rosbag2_py._metadata import MetadataIo
from rosbag2_py._storage import (
    BagMetadata,
    BagTime,
    ConverterOptions,
    Duration,
    FileInformation,
    MessageDefinition,
    StorageOptions,
    TopicInformation,
    TopicMetadata,
    get_default_storage_id,
    nanoseconds_of,
)

__all__ = [
    "SequentialCompressionWriter",
    "SequentialWriter",
    "get_registered_compressors",
    "get_registered_serializers",
    "get_registered_writers",
]

FLUSH_SECONDS = 1.0
"""Seconds between flushes: a killed recording loses at most the messages of this time."""

SLOWER_PER_PIECE = 0.001
"""Seconds that are added for each piece of a file, because each flush rewrites the index of all pieces."""

_TIME_AT_END = re.compile(r"_\d{4}_\d\d_\d\d-\d\d_\d\d_\d\d$")
"""What `ros2 bag record` adds to the name of a bag that was given none."""


class SequentialWriter:
    """Writes a bag: `open`, `create_topic`, `write` …; `close`, or the garbage collector, closes it."""

    def __init__(self, log: Log = to_console) -> None:
        self._log = log
        self._options = CompressionOptions()
        self._bag: _Bag | None = None

    def open(self, storage_options: StorageOptions, converter_options: ConverterOptions | None = None) -> None:
        """Create the folder and the first file. Raises RuntimeError if the folder exists."""
        self.close()
        self._bag = _Bag(storage_options, self._options, self._log)
        # Tutorials' programs never close their bags: that happens when Python exits, at the latest.
        self._end = weakref.finalize(self, self._bag.close)

    def _opened(self) -> _Bag:
        if self._bag is None:
            raise RuntimeError("Bag is not open. Call open() before writing.")
        return self._bag

    def create_topic(self, topic: TopicMetadata, definition: MessageDefinition | None = None) -> None:
        """Add a topic, before its first message."""
        self._opened().create_topic(topic, definition)

    def remove_topic(self, topic: TopicMetadata) -> None:
        """Remove a topic that has no messages yet."""
        self._opened().topics.pop(topic.name, None)

    def write(self, topic_name: str, message: bytes, recv_timestamp: int, send_timestamp: int | None = None) -> None:
        """Add a message, as CDR bytes from `serialize_message`; times are in nanoseconds since 1970."""
        sent = recv_timestamp if send_timestamp is None else send_timestamp
        self._opened().write(topic_name, bytes(message), recv_timestamp, sent)

    def flush(self) -> None:
        """Write everything to the disk (the real one has no such method: its cache has a thread)."""
        self._opened().flush()

    def split_bagfile(self) -> None:
        """Continue in a new file."""
        self._opened().split()

    def take_snapshot(self) -> bool:
        """In snapshot mode: write the messages kept in memory. Returns False in any other mode."""
        return self._opened().take_snapshot()

    def close(self) -> None:
        """Finish the bag; a second call does nothing."""
        if self._bag is not None:
            self._end()
            self._bag = None


class SequentialCompressionWriter(SequentialWriter):
    """A writer that compresses each finished file, or each message."""

    def __init__(self, compression_options: CompressionOptions | None = None, log: Log = to_console) -> None:
        super().__init__(log)
        self._options = compression_options or CompressionOptions("zstd", CompressionMode.FILE)


def _file_name(bag: str, index: int) -> str:
    """Return the name of a bag's file without its suffix; `bag` is the folder's name."""
    if value("bag.file_names") == "name_index":
        return f"{bag}_{index}"
    return f"{index}_{_TIME_AT_END.sub('', bag)}_{time.strftime('%Y_%m_%d-%H_%M_%S')}"


class _Bag:
    """The state of a bag that is being written. `on_split(closed, opened)` gets the paths after each split."""

    def __init__(self, options: StorageOptions, compression: CompressionOptions, log: Log) -> None:
        self._log = log
        self.folder = Path(options.uri)
        self.storage = options.storage_id or get_default_storage_id()
        self.options = options
        self.compression = compression
        self.on_split: Callable[[str, str], None] | None = None
        self.topics: dict[str, tuple[TopicMetadata, MessageDefinition]] = {}
        self._check()
        self._pack = zstd_compress if compression.compression_mode else None
        self._source = LocalMessageDefinitionSource()
        self._files: list[FileInformation] = []
        self._counts: list[Counter[str]] = []
        """The messages in each file, by topic."""
        self._begun = 0
        """Files so far, with those that are deleted."""
        self._kept = LastMoments(options.max_cache_size, options.max_cache_duration)
        self._repeated = LastMessages()
        self._latest = (0, 0)
        """When the last message was received, and sent."""
        self._closed = False
        self._broken = False
        try:
            self.folder.mkdir(parents=True)
        except FileExistsError:
            raise RuntimeError(f"Bag directory already exists ({self.folder}), can't overwrite existing bag") from None
        except OSError:
            raise RuntimeError(f"Failed to create bag directory ({self.folder}).") from None
        try:
            self._begin_file()
            self._write_metadata()
        except OSError:
            for left in (self._path, self._path.with_name(f"{self._path.name}-journal")):
                left.unlink(missing_ok=True)  # both belong to this bag, which failed to be created
            with suppress(OSError):
                self.folder.rmdir()
            raise

    def _check(self) -> None:
        if self.storage not in SUFFIXES:
            raise RuntimeError("No storage could be initialized. Abort")
        preset = self.options.storage_preset_profile
        known = presets(self.storage)
        if preset and preset not in known:
            listed = ", ".join(map(repr, known))
            raise RuntimeError(f"unknown {self.storage} storage preset profile (valid options are {listed}): {preset}")
        if self.compression.compression_mode or preset.startswith("zstd_"):
            codec("zstd")  # asked for before anything is made
        least, size = MINIMUM_SPLIT[self.storage], self.options.max_bagfile_size
        if 0 < size < least:
            raise RuntimeError(
                "Invalid bag splitting size given. Please provide a value greater than "
                f"{least}. Specified value of {size}"
            )

    # -- files ---------------------------------------------------------------------------------------------------------

    def _begin_file(self) -> None:
        from day6_core.ros.distribution import current

        self._distro = os.environ.get("ROS_DISTRO", current())
        name = _file_name(self.folder.name, self._begun) + SUFFIXES[self.storage]
        self._begun += 1
        self._path = self.folder / name
        preset = self.options.storage_preset_profile
        self._file: BagWriter = create_file(self._path, self.storage, preset, self._distro, self._log)
        self._files.append(FileInformation(name, BagTime(), Duration(), 0))
        self._counts.append(Counter())
        for topic, definition in self.topics.values():
            self._file.create_topic(topic, definition)
        self._begin: int | None = None
        self._last = 0
        self._dirty = False
        self._flushed = 0.0

    def split(self) -> None:
        """Finish the file and continue in the next one."""
        before = self._path
        self._end_file()
        self._begin_file()
        self._delete_oldest()
        if not self.options.snapshot_mode:
            for message in self._repeated.as_of(*self._latest):
                self._put(message)
        self._write_metadata()
        if self.on_split is not None:
            self.on_split(str(before), str(self._path))

    def _end_file(self) -> None:
        if self.options.max_cache_size or self.options.max_cache_duration:
            self._log("INFO", "rosbag2_cpp", "Writing remaining messages from cache to the bag. It may take a while")
        self._file.metadata = self.metadata()
        self._file.close()
        if self._pack is not None and self.compression.compression_mode == CompressionMode.FILE:
            packed = self._path.with_name(f"{self._path.name}.zstd")
            replace_file(packed, self._pack(self._path.read_bytes(), 1), mode=0o666, sync=False)
            self._path.unlink()
            self._files[-1].path = packed.name

    def _delete_oldest(self) -> None:
        most = self.options.max_bag_files
        while most and len(self._files) > most:
            oldest = self._files[0]
            path = self.folder / oldest.path
            try:
                size = path.stat().st_size
                path.unlink()
            except FileNotFoundError:
                self._log("ERROR", "rosbag2_cpp", f"Oldest bagfile to delete not found: {path}")
            except OSError as error:
                self._log("ERROR", "rosbag2_cpp", f"Failed to delete oldest bagfile: {path}. Error: {error.strerror}")
                return  # tried again at the next split
            else:
                span = nanoseconds_of(oldest.duration)
                self._log("INFO", "rosbag2_cpp", f"Deleted oldest bagfile: {oldest.path} ({size} bytes, {span} ns)")
            del self._files[0], self._counts[0]

    # -- messages ------------------------------------------------------------------------------------------------------

    def create_topic(self, topic: TopicMetadata, definition: MessageDefinition | None) -> None:
        if topic.name not in self.topics:
            text = definition or self._source.get_full_text(topic.type)
            self.topics[topic.name] = (topic, text)
            self._file.create_topic(topic, text)

    def repeat(self, topic: str, depth: int) -> None:
        """Begin each new file with the last messages of a topic."""
        self._repeated.add_topic(topic, depth)

    def write(self, topic: str, data: bytes, received_ns: int, sent_ns: int) -> None:
        if topic not in self.topics:
            raise RuntimeError(f"Topic '{topic}' has not been created yet! Call 'create_topic' first.")
        message = Kept(topic, data, received_ns, sent_ns)
        if self.options.snapshot_mode:
            self._kept.add(message)
        else:
            if self._is_full(received_ns):
                with self._marking_broken():
                    self.split()
            self._write(message)
        self._repeated.add(message)
        self._latest = received_ns, sent_ns

    def _write(self, message: Kept) -> None:
        self._put(message)
        now = time.monotonic()
        if now - self._flushed > FLUSH_SECONDS + SLOWER_PER_PIECE * self._file.pieces:
            self.flush()

    def _put(self, message: Kept) -> None:
        topic, data, received_ns, sent_ns = message
        with self._marking_broken():
            if self._pack is not None and self.compression.compression_mode == CompressionMode.MESSAGE:
                data = self._pack(data, 1)
            self._file.write(topic, data, received_ns, sent_ns)
        self._counts[-1][topic] += 1
        self._begin = received_ns if self._begin is None else min(self._begin, received_ns)
        self._last = max(self._last, received_ns)
        self._files[-1].message_count += 1
        self._dirty = True

    def _is_full(self, now_ns: int) -> bool:
        if self._begin is None:
            return False
        size, seconds = self.options.max_bagfile_size, self.options.max_bagfile_duration
        return bool(size and self._file.size > size) or bool(seconds and now_ns - self._begin > seconds * SECOND)

    def take_snapshot(self) -> bool:
        if not self.options.snapshot_mode:
            return False
        kept = self._kept.take()
        first = min(kept, key=lambda each: each.received_ns, default=None)
        if first is not None:
            kept[:0] = self._repeated.as_of(first.received_ns, first.sent_ns, before=True)
        for message in kept:
            if self._is_full(message.received_ns):
                self.split()
            self._write(message)
        self.flush()
        return True

    # -- disk ----------------------------------------------------------------------------------------------------------

    def flush(self) -> None:
        """Write pending messages to the disk. Raises OSError, then and at every later call."""
        if self._dirty:
            with self._marking_broken():
                self._file.metadata = self.metadata()
                self._file.flush()
                self._write_metadata()
            self._dirty = False
        self._flushed = time.monotonic()

    @contextmanager
    def _marking_broken(self) -> Iterator[None]:
        """Mark the bag as broken on a full disk (or a removed folder): nothing more is written to it."""
        try:
            yield
        except OSError:
            self._broken = True
            raise

    def _write_metadata(self) -> None:
        MetadataIo().write_metadata(str(self.folder), self.metadata())

    def metadata(self) -> BagMetadata:
        """Return the metadata of the bag in its current state."""
        begin = self._begin or 0
        self._files[-1].starting_time = BagTime(begin)
        self._files[-1].duration = Duration(0, max(0, self._last - begin))
        written = [file for file in self._files if file.message_count]
        start = min((file.starting_time.nanoseconds for file in written), default=0)
        end = max((file.starting_time.nanoseconds + file.duration.nanoseconds for file in written), default=start)
        counts = sum(self._counts, Counter())
        packed = self._closed and self._pack is not None
        mode = self.compression.compression_mode
        if self._pack is not None and mode == CompressionMode.MESSAGE:
            packed = True
        return BagMetadata(
            storage_identifier=self.storage,
            relative_file_paths=[file.path for file in self._files],
            files=self._files,
            duration=Duration(0, end - start),
            starting_time=BagTime(start),
            message_count=sum(file.message_count for file in self._files),
            topics_with_message_count=[
                TopicInformation(topic, counts[name]) for name, (topic, _) in self.topics.items()
            ],
            compression_format=self.compression.compression_format if packed else "",
            compression_mode=mode.name if packed else "",
            custom_data=dict(self.options.custom_data),
            ros_distro=self._distro,
        )

    def close(self) -> None:
        """Finish the bag. Raises OSError; the files are then as after the last flush."""
        if self._closed:
            return
        self._closed = True
        if self._broken:
            self._file.close()  # metadata.yaml matches the last flush
            return
        self._end_file()
        self._write_metadata()
