"""Opening a bag: its metadata at once, then block after block of its files. All of it belongs into a thread."""

from __future__ import annotations

import os
import shutil
import tempfile
import weakref
from collections.abc import Callable, Iterable
from dataclasses import dataclass, field
from pathlib import Path

from rosbag2_py._blocks import open_blocks
from rosbag2_py._compression import codec
from rosbag2_py._files import NO_STORAGE
from rosbag2_py._metadata import FILE_NAME, MetadataIo
from rosbag2_py._reader import last_moment
from rosbag2_py._storage import MessageDefinition, TopicMetadata, nanoseconds_of

from day6_core.ros.programs.rqt_bag.model.timeline import BagSource, Timeline


@dataclass(eq=False)
class OpenBag:
    """A bag that is open: its topics, and its files as far as they are indexed."""

    path: Path
    size: int = 0
    """Bytes on the disk."""
    start_ns: int | None = None
    end_ns: int | None = None
    topics: dict[str, TopicMetadata] = field(default_factory=dict)
    definitions: dict[str, MessageDefinition] = field(default_factory=dict)
    sources: list[BagSource] = field(default_factory=list)
    is_complete: bool = True
    _files: list[Path] = field(default_factory=list)
    _storage: str = ""
    _compression: tuple[str, str] = ("", "")
    """Mode and format."""
    _unpacked: float = 0.0
    """How many files are unpacked, of the last one a part."""

    @property
    def passed(self) -> float:
        """Which part of its files is read, 0 to 1: those that have to be unpacked are indexed in no time after that."""
        return (self._unpacked or sum(source.passed for source in self.sources)) / max(1, len(self._files))

    def close(self) -> None:
        """Close its files."""
        for source in self.sources:
            source.close()


def is_bag(path: Path) -> bool:
    """Whether rqt_bag takes this path for a bag: a folder with a metadata.yaml, that file, or a file of either storage.

    The real one refuses the last of these (rqt_bag/bag.py, _isbag).
    """
    if os.path.isfile(path):
        return path.name == FILE_NAME or path.suffix in (".mcap", ".db3")
    return os.path.isfile(path / FILE_NAME)


def open_bag(path: Path) -> OpenBag:
    """Read what metadata.yaml says of a bag; one file of a bag has none. Raises RuntimeError and OSError."""
    if path.name == FILE_NAME and path.is_file():
        path = path.parent
    if path.is_file():
        return OpenBag(path, path.stat().st_size, _files=[path])
    io = MetadataIo()
    if not io.metadata_file_exists(str(path)):
        raise RuntimeError(NO_STORAGE)
    metadata = io.read_metadata(str(path))
    start = nanoseconds_of(metadata.starting_time)
    counted = bool(metadata.message_count)
    return OpenBag(
        path,
        metadata.bag_size,
        start if counted else None,
        last_moment(metadata) if counted else None,
        {each.topic_metadata.name: each.topic_metadata for each in metadata.topics_with_message_count},
        _files=[_find(path, name) for name in metadata.relative_file_paths],
        _storage=metadata.storage_identifier,
        _compression=(metadata.compression_mode.upper(), metadata.compression_format),
    )


def _find(folder: Path, name: str) -> Path:
    """The path of a file; early versions list files with the bag's folder in front."""
    path = folder / name
    return path if path.exists() or "/" not in name else folder / Path(name).name


def index_bag(bag: OpenBag, timeline: Timeline, cancelled: Callable[[], bool]) -> None:
    """Add the bag's files to the timeline, block after block, until `cancelled`. Raises RuntimeError and OSError."""
    mode, format_ = bag._compression
    for path in bag._files:
        if cancelled():
            return
        plain = _unpack(bag, path, cancelled) if mode == "FILE" and path.suffix == ".zstd" else path
        source = BagSource(open_blocks(plain, bag._storage), format_ if mode == "MESSAGE" else "")
        bag.sources.append(source)
        _add_topics(bag, source.topics())
        for block in source.blocks():
            if cancelled():
                return
            if block.counts.keys() - bag.topics.keys():
                _add_topics(bag, source.topics())
            timeline.add(source, block)
        bag.definitions.update((each.topic_type, each) for each in source.definitions())
        bag.is_complete = bag.is_complete and source.is_complete


def _add_topics(bag: OpenBag, topics: Iterable[TopicMetadata]) -> None:
    """What metadata.yaml says of a topic counts before what the file says."""
    bag.topics = {**{topic.name: topic for topic in topics}, **bag.topics}


def _unpack(bag: OpenBag, path: Path, cancelled: Callable[[], bool]) -> Path:
    """Decompress a file, or its first part, into a temporary folder, which is removed with the bag."""
    folder = Path(tempfile.mkdtemp(prefix="rqt_bag-"))
    weakref.finalize(bag, shutil.rmtree, folder, ignore_errors=True)
    target, zstandard = folder / path.stem, codec("zstd")
    size, before = path.stat().st_size, bag._unpacked
    try:
        with path.open("rb") as packed, target.open("xb") as plain:
            for data in zstandard.ZstdDecompressor().read_to_iter(packed, write_size=1 << 20):
                plain.write(data)
                bag._unpacked = before + packed.tell() / size
                if cancelled():
                    break
    except zstandard.ZstdError as error:
        raise RuntimeError(f"zstd: {error}") from None
    return target
