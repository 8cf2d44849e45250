"""`SequentialReader`: the messages of a bag in sequence, whatever its files and storage."""

from __future__ import annotations

import shutil
import tempfile
import weakref
from collections.abc import Iterator
from itertools import islice, takewhile
from pathlib import Path

from rosbag2_py._compression import decompress
from rosbag2_py._console import Log, to_console
from rosbag2_py._files import NO_STORAGE, BagReader, get_registered_readers, open_file, reading
from rosbag2_py._metadata import MetadataIo
from rosbag2_py._storage import (
    BagMetadata,
    ConverterOptions,
    Message,
    MessageDefinition,
    ReadOrder,
    ReadOrderSortBy,
    StorageFilter,
    StorageOptions,
    TopicMetadata,
    Wanted,
    nanoseconds_of,
)

__all__ = ["SequentialCompressionReader", "SequentialReader", "get_registered_readers"]

_LAST = 2**63 - 1
_LOGGER = "rosbag2_cpp"


class SequentialReader:
    """Reads the messages of a bag (its folder, or one file of it) by time. Raises RuntimeError for anything else."""

    def __init__(self, log: Log = to_console) -> None:
        self._log = log
        self._metadata: BagMetadata | None = None
        self._folder = Path()
        self._files: list[Path] = []
        self._storage = ""
        self._open: dict[Path, BagReader] = {}
        self._filter = StorageFilter()
        self._order = ReadOrder()
        self._start_ns: int | None = None
        self._end_ns = _LAST
        self._skipped = 0
        """Messages from `_start_ns` on, of all topics, that were passed before the stream began."""
        self._passed = 0
        """Messages since then that the filter let through, of the time `_start_ns` (by file: all)."""
        self._stream: Iterator[Message] | None = None
        self._next: Message | None = None
        self._unpacked: Path | None = None

    def open_uri(self, uri: str) -> None:
        """Open a bag; its storage is detected."""
        self.open(StorageOptions(uri))

    def open(self, storage_options: StorageOptions, converter_options: ConverterOptions | None = None) -> None:
        """Open a bag; a second call closes the first one."""
        self.close()
        self._folder = Path(storage_options.uri)
        self._storage = storage_options.storage_id
        io = MetadataIo()
        if io.metadata_file_exists(str(self._folder)):
            self._metadata = metadata = io.read_metadata(str(self._folder))
            self._storage = self._storage or metadata.storage_identifier
            self._files = [self._find(path) for path in metadata.relative_file_paths]
            if not self._files:
                self._log("WARN", _LOGGER, "No file paths were found in metadata.")
                return
            self._is_in_order(self._reader(self._files[0]))
        else:
            self._files = [self._folder]
            file = self._reader(self._folder, NO_STORAGE)
            with reading(self._folder):
                self._metadata = file.metadata()
            if not self._is_in_order(file):
                self._log("WARN", _LOGGER, "Could not set read order on open(), falling back to file order")
        if not self._metadata.topics_with_message_count:
            self._log("WARN", _LOGGER, "No topics were listed in metadata.")
        if storage_options.start_time_ns >= 0:
            self._start_ns = storage_options.start_time_ns
        self._end_ns = storage_options.end_time_ns if storage_options.end_time_ns >= 0 else _LAST

    def _find(self, name: str) -> Path:
        """Return the path of a file; early versions list files with the bag's folder in front."""
        path = self._folder / name
        return path if path.exists() or "/" not in name else self._folder / Path(name).name

    def close(self) -> None:
        """Close the files."""
        self._stream = None
        self._next = None
        for file in self._open.values():
            file.close()
        self._open.clear()
        self._metadata = None
        self._go_to(None)

    def _is_in_order(self, file: BagReader) -> bool:
        """Whether a file can be read by time; otherwise it is read as it was written."""
        if not file.has_time_order:
            text = "attempted to read in receive timestamp order with no message index"
            self._log("WARN", "rosbag2_storage_mcap", text)
        return file.has_time_order

    def _reader(self, path: Path, problem: str = "No storage could be initialized. Abort") -> BagReader:
        found = self._open.get(path)
        if found is None:
            mode = self._metadata.compression_mode if self._metadata is not None else ""
            packed = mode.upper() == "FILE" and path.suffix == ".zstd"
            found = open_file(self._unpack(path) if packed else path, self._storage, self._log)
            if found is None:
                raise RuntimeError(problem)
            self._open[path] = found
        return found

    def _unpack(self, path: Path) -> Path:
        """Decompress a file into a temporary folder, which is removed with this reader."""
        if self._unpacked is None:
            self._unpacked = Path(tempfile.mkdtemp(prefix="rosbag2-"))
            weakref.finalize(self, shutil.rmtree, self._unpacked, ignore_errors=True)
        target = self._unpacked / path.stem
        try:
            target.write_bytes(decompress("zstd", path.read_bytes()))
        except OSError as error:
            raise RuntimeError(f"{error.strerror}: {path}") from None
        return target

    # -- contents ------------------------------------------------------------------------------------------------------

    def get_metadata(self) -> BagMetadata:
        """Return the contents of metadata.yaml, or the metadata of the file itself."""
        if self._metadata is None:
            raise RuntimeError("Bag is not open. Call open() before reading.")
        return self._metadata

    def get_all_topics_and_types(self) -> list[TopicMetadata]:
        """Return the topics of the bag."""
        return [each.topic_metadata for each in self.get_metadata().topics_with_message_count]

    def get_all_message_definitions(self) -> list[MessageDefinition]:
        """Return the texts of the message types, each once."""
        found: dict[str, MessageDefinition] = {}
        for path in self._files:
            file = self._reader(path)
            with reading(path):
                for definition in file.definitions():
                    found.setdefault(definition.topic_type, definition)
        return list(found.values())

    # -- messages ------------------------------------------------------------------------------------------------------

    def set_filter(self, storage_filter: StorageFilter) -> None:
        """Continue with only those topics that the filter allows."""
        self._skipped, self._passed = self._place(), 0
        self._filter = storage_filter
        self._restart()

    def reset_filter(self) -> None:
        """Continue with all topics."""
        self.set_filter(StorageFilter())

    def seek(self, timestamp: int) -> None:
        """Continue with the first message at or after (in reverse: before) this time."""
        self._go_to(timestamp)

    def set_read_order(self, read_order: ReadOrder) -> bool:
        """Choose the order; returns False for one in which the bag can't be read."""
        if read_order.sort_by == ReadOrderSortBy.PublishedTimestamp:
            return False
        if read_order.sort_by == ReadOrderSortBy.File and read_order.reverse:
            return False
        by_time = read_order.sort_by == ReadOrderSortBy.ReceivedTimestamp
        if by_time and self._files and not self._is_in_order(self._reader(self._files[0])):
            return False
        if self._passed or self._skipped:
            self._go_to(self._next_start())
        self._order = read_order
        self._restart()
        return True

    def has_next(self) -> bool:
        """Return whether there is another message."""
        self.get_metadata()
        if self._next is None:
            if self._stream is None:
                self._stream = self._messages()
            self._next = next(self._stream, None)
        return self._next is not None

    def read_next(self) -> tuple[str, bytes, int]:
        """Return the next message: topic, CDR bytes, time received in nanoseconds since 1970."""
        message = self.read_next_message()
        return message.topic, message.data, message.received_ns

    def read_next_message(self) -> Message:
        """Return the next message with all its fields. Raises RuntimeError at the end."""
        if not self.has_next() or self._next is None:
            raise RuntimeError("Bag is at end. No next message.")
        message, self._next = self._next, None
        # A filter or order that is changed later applies from here on.
        if self._order.sort_by != ReadOrderSortBy.File and message.received_ns != self._start_ns:
            self._start_ns, self._skipped, self._passed = message.received_ns, 0, 0
        self._passed += 1
        return message

    def _restart(self) -> None:
        self._stream = None
        self._next = None

    def _go_to(self, start_ns: int | None) -> None:
        self._start_ns, self._skipped, self._passed = start_ns, 0, 0
        self._restart()

    def _next_start(self) -> int | None:
        """Return the time after `_start_ns` in this order."""
        return self._start_ns if self._start_ns is None else self._start_ns + (-1 if self._order.reverse else 1)

    def _place(self) -> int:
        """Return how many messages from `_start_ns` on have been passed, whatever their topics."""
        left = self._passed
        for number, message in enumerate(self._from(lambda topic: True) if left else ()):
            left -= number >= self._skipped and self._filter.allows(message.topic)
            if not left:
                return number + 1
        return self._skipped

    def _messages(self) -> Iterator[Message]:
        allows = self._filter.allows
        if not self._skipped:
            yield from self._from(allows)
            return
        rest = islice(self._from(lambda topic: True), self._skipped, None)
        if self._order.sort_by == ReadOrderSortBy.File:
            yield from (message for message in rest if allows(message.topic))
            return
        now = takewhile(lambda message: message.received_ns == self._start_ns, rest)
        following = self._next_start()
        yield from (message for message in now if allows(message.topic))
        yield from self._from(allows, following)

    def _from(self, wanted: Wanted, start_ns: int | None = None) -> Iterator[Message]:
        """Yield the messages of wanted topics from `start_ns` on, by default from `_start_ns`."""
        reverse = self._order.reverse
        start = self._start_ns if start_ns is None else start_ns
        if start is None:
            start = _LAST if reverse else 0
        metadata = self.get_metadata()
        unpack = metadata.compression_mode.upper() == "MESSAGE"
        # After a split the order of the names is the order of time.
        for path in reversed(self._files) if reverse else self._files:
            file = self._reader(path)
            by_file = self._order.sort_by == ReadOrderSortBy.File or not file.has_time_order
            stream = file.messages(start, wanted, reverse=reverse, by_file=by_file)
            with reading(path):
                for message in stream:
                    if message.received_ns > self._end_ns:
                        continue
                    if unpack:
                        message = message._replace(data=decompress(metadata.compression_format, message.data))
                    yield message

    def __del__(self) -> None:
        for file in self._open.values():
            file.close()


class SequentialCompressionReader(SequentialReader):
    """The reader for compressed bags; here `SequentialReader` reads both kinds."""


def last_moment(metadata: BagMetadata) -> int:
    """Return the time of the last message, nanoseconds since 1970."""
    return nanoseconds_of(metadata.starting_time) + nanoseconds_of(metadata.duration)
