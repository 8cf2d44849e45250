"""Records topics of the graph into a new bag, and puts what it hears on the timeline."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterator, Sequence
from pathlib import Path
from typing import TYPE_CHECKING

from rosbag2_py._blocks import Block, Entries
from rosbag2_py._console import quiet
from rosbag2_py._metadata import folder_size
from rosbag2_py._options import RecordOptions
from rosbag2_py._recording import Recording
from rosbag2_py._storage import Message, MessageDefinition, StorageOptions, TopicMetadata

from day6_core.ros.programs.rqt_bag.model.timeline import BagSource, Timeline

if TYPE_CHECKING:
    from rclpy.node import Node

POLL_SECONDS = 0.1
"""How often it looks for new topics, and puts what came on the timeline."""


class Recorder:
    """One recording. `topics` None means all. Raises RuntimeError and OSError when the bag can't be created."""

    def __init__(self, node: Node, path: Path, topics: Sequence[str] | None, timeline: Timeline) -> None:
        self.path = path
        self.messages = 0
        self.size = 0
        """Bytes on the disk."""
        self.types: dict[str, str] = {}
        """Of the topics that it listens to, by name."""
        self.failure: OSError | None = None
        self._timeline = timeline
        self._source = BagSource(_Written())
        self._counts: Counter[str] = Counter()
        self._span: tuple[int, int] | None = None
        options = RecordOptions(
            all_topics=topics is None, topics=list(topics or ()), rmw_serialization_format="cdr", compression_mode=""
        )
        storage = StorageOptions(str(path))
        self._recording = Recording(node, storage, options, keyboard=False, host=self, log=quiet)
        self._recording.start()

    @property
    def paused(self) -> bool:
        return self._recording.paused

    def toggle_paused(self) -> None:
        """Write nothing for a while, or go on."""
        (self._recording.resume if self.paused else self._recording.pause)()

    def received(self, topic: str, received_ns: int) -> None:
        """A message was written."""
        self.messages += 1
        self._counts[topic] += 1
        first, last = self._span or (received_ns, received_ns)
        self._span = (min(first, received_ns), max(last, received_ns))

    def failed(self, error: OSError) -> None:
        """A message could not be written."""
        self.failure = self.failure or error

    def poll(self) -> None:
        """Look for new topics, flush, and put what came on the timeline; `failure` tells what went wrong."""
        try:
            if self.failure is None:
                self._recording.poll()
            self.size = folder_size(self.path)
        except OSError as error:
            self.failed(error)
        self.types = self._recording.types
        if self._span is not None:
            self._timeline.add(self._source, Block(*self._span, dict(self._counts), None))
            self._counts.clear()
            self._span = None

    def stop(self) -> None:
        """Finish the bag."""
        try:
            self._recording.stop()
        except OSError as error:
            self.failed(error)


class _Written:
    """The file of a recording, from which nothing is read while it is written."""

    is_complete = True
    passed = 1.0

    def blocks(self) -> Iterator[Block]:
        return iter(())

    def entries(self, block: Block) -> dict[str, Entries]:
        return {}

    def message(self, block: Block, topic: str, key: int) -> Message:
        raise RuntimeError("the bag is open for writing only")

    def topics(self) -> list[TopicMetadata]:
        return []

    def definitions(self) -> list[MessageDefinition]:
        return []

    def close(self) -> None:
        return None
