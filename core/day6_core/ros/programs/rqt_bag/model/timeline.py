"""Where the messages of the open bags are in time: counts for drawing, and the messages around a moment.

What is kept are the blocks of the bags' files (`rosbag2_py._blocks`); the times of single messages are read when a block is
looked into, and those of the last blocks are kept. Counting reads nothing, so a window may count whenever it draws. Everything
else here reads files: it belongs into a thread.
"""

from __future__ import annotations

import threading
from bisect import bisect_left, bisect_right
from collections import OrderedDict
from collections.abc import Iterable, Iterator, Sequence
from itertools import pairwise
from operator import attrgetter
from typing import NamedTuple

from rosbag2_py._blocks import Block, BlockFile, Entries
from rosbag2_py._compression import decompress
from rosbag2_py._storage import NANOSECONDS, Message, MessageDefinition, TopicMetadata

KEPT = 256
"""Blocks of which the times of the messages are kept."""

MOST_AT_ONCE = 256
MOST_BYTES = 16 << 20
"""Messages, and bytes of them, that are read in one go."""

LATEST = 2**63 - 1

MOST_IN_SIGHT = 200
"""With no more blocks in sight the times of their messages are read, so that each one is drawn where it is.

With more of them a block is narrower than a column on most screens.
"""


class BagSource:
    """One file of a bag. Threads take turns at it; `compression` is what each message is compressed with."""

    def __init__(self, file: BlockFile, compression: str = "") -> None:
        self._file = file
        self._compression = compression
        self._lock = threading.Lock()
        self._closed = False

    @property
    def is_complete(self) -> bool:
        """Whether the file goes on to its regular end, as far as `blocks` has come."""
        return self._file.is_complete

    @property
    def passed(self) -> float:
        """Which part of the file `blocks` has gone through, 0 to 1."""
        return self._file.passed

    def topics(self) -> list[TopicMetadata]:
        """The topics, as far as `blocks` has come. Raises RuntimeError."""
        with self._lock:
            return self._file.topics()

    def definitions(self) -> list[MessageDefinition]:
        """The texts of the message types. Raises RuntimeError."""
        with self._lock:
            return [] if self._closed else self._file.definitions()

    def blocks(self) -> Iterator[Block]:
        """Yield the blocks; others get their turn between two of them. Raises RuntimeError."""
        found = self._file.blocks()
        while True:
            with self._lock:
                block = None if self._closed else next(found, None)
            if block is None:
                return
            yield block

    def entries(self, block: Block) -> dict[str, Entries]:
        """The times of a block's messages. Raises RuntimeError."""
        with self._lock:
            return {} if self._closed else self._file.entries(block)

    def message(self, block: Block, topic: str, key: int) -> Message:
        """Read one message. Raises RuntimeError."""
        with self._lock:
            if self._closed:
                raise RuntimeError("the bag is closed")
            message = self._file.message(block, topic, key)
        if self._compression:
            return message._replace(data=decompress(self._compression, message.data))
        return message

    def close(self) -> None:
        """Close the file, when no thread is at it."""
        with self._lock:
            self._closed = True
            self._file.close()


class Found(NamedTuple):
    """A message in the index, not read yet."""

    time_ns: int
    topic: str
    key: int
    block: Block
    source: BagSource

    def read(self) -> Message:
        """Read it. Raises RuntimeError."""
        return self.source.message(self.block, self.topic, self.key)


class Passed(NamedTuple):
    """A message that was read, and where it is in the index."""

    found: Found
    message: Message


class _Lane:
    """The blocks with messages of one topic, by their beginning. It only grows; a block in between makes a new one."""

    def __init__(self, places: Iterable[tuple[BagSource, Block]] = (), topic: str = "") -> None:
        self.topic = topic
        self.starts: list[int] = []
        self.places: list[tuple[BagSource, Block]] = []
        self.latest: list[int] = []
        """The last end of the blocks so far: blocks may overlap."""
        self.upto: list[int] = []
        """The number of messages of the blocks so far."""
        for source, block in places:
            self._append(source, block)

    def _append(self, source: BagSource, block: Block) -> None:
        self.places.append((source, block))
        self.latest.append(max(block.end_ns, self.latest[-1] if self.latest else block.end_ns))
        self.upto.append(block.counts[self.topic] + (self.upto[-1] if self.upto else 0))
        self.starts.append(block.start_ns)  # the last, because other threads go by its length

    def with_block(self, source: BagSource, block: Block) -> _Lane:
        """The lane with one more block: this one if it is the last."""
        if not self.starts or block.start_ns >= self.starts[-1]:
            self._append(source, block)
            return self
        at = bisect_right(self.starts, block.start_ns)
        return _Lane([*self.places[:at], (source, block), *self.places[at:]], self.topic)

    def count_until(self, moment: int) -> float:
        """Messages before a moment; within a block whose times are not known they are spread evenly."""
        at = bisect_left(self.starts, moment)
        if at == 0:
            return 0.0
        before = self.upto[at - 2] if at > 1 else 0
        _, block = self.places[at - 1]
        count = block.counts[self.topic]
        known = block.entries
        if moment > block.end_ns:
            return float(before + count)
        if known is not None and self.topic in known:
            return float(before + bisect_left(known[self.topic].times, moment))
        return before + count * (moment - block.start_ns) / max(1, block.end_ns - block.start_ns)


class Timeline:
    """The index of all open bags. `start_ns` and `end_ns` are nanoseconds since 1970."""

    def __init__(self) -> None:
        self.start_ns: int | None = None
        self.end_ns: int | None = None
        self.version = 0
        """Grows whenever something would be counted otherwise."""
        self.blocks = 0
        """How many there are."""
        self.messages = 0
        """How many messages they hold."""
        self._lanes: dict[str, _Lane] = {}
        self._kept: OrderedDict[Block, None] = OrderedDict()
        self._keeping = threading.Lock()

    # -- growing -------------------------------------------------------------------------------------------------------

    def span(self, start_ns: int, end_ns: int) -> None:
        """Make the timeline reach over this time."""
        self.start_ns = start_ns if self.start_ns is None else min(self.start_ns, start_ns)
        self.end_ns = end_ns if self.end_ns is None else max(self.end_ns, end_ns)
        self.version += 1

    def add(self, source: BagSource, block: Block) -> None:
        """Add a block; one thread at a time."""
        self.blocks += 1
        block.number = self.blocks
        self.messages += sum(block.counts.values())
        for topic in block.counts:
            lane = self._lanes.get(topic) or _Lane(topic=topic)
            self._lanes[topic] = lane.with_block(source, block)
        if block.counts:
            self.span(block.start_ns, block.end_ns)

    # -- counting ------------------------------------------------------------------------------------------------------

    def count(self, topic: str) -> int:
        """The messages of a topic so far."""
        lane = self._lanes.get(topic)
        return lane.upto[len(lane.starts) - 1] if lane is not None and lane.starts else 0

    def columns(self, topic: str, left_ns: int, right_ns: int, columns: int) -> list[float]:
        """How many messages lie in each of so many equal parts of a time."""
        lane = self._lanes.get(topic)
        if lane is None:
            return [0.0] * columns
        edges = [left_ns + (right_ns - left_ns) * column // columns for column in range(columns)]
        counts = [lane.count_until(edge) for edge in (*edges, right_ns + 1)]
        return [max(0.0, after - before) for before, after in pairwise(counts)]

    def estimate(self, topics: Iterable[str], after_ns: int, until_ns: int) -> float:
        """About how many messages of these topics lie in a time."""
        lanes = [self._lanes[topic] for topic in topics if topic in self._lanes]
        return sum(lane.count_until(until_ns + 1) - lane.count_until(after_ns + 1) for lane in lanes)

    # -- looking into blocks (in a thread) -----------------------------------------------------------------------------

    def look_at(self, left_ns: int, right_ns: int) -> bool:
        """Read the times of the messages in sight, unless there are too many blocks; whether anything was read."""
        places: dict[Block, BagSource] = {}
        for lane in list(self._lanes.values()):
            first, end = bisect_right(lane.latest, left_ns - 1), bisect_right(lane.starts, right_ns)
            if end - first > MOST_IN_SIGHT:
                return False
            places.update((block, source) for source, block in lane.places[first:end] if block.entries is None)
        if not places or len(places) > MOST_IN_SIGHT:
            return False
        for block, source in places.items():
            self._entries(source, block)
        self.version += 1
        return True

    def newest(self, topic: str, at_ns: int, most: int = 1) -> list[Found]:
        """The last messages of a topic at or before a moment, at most so many, by time. Raises RuntimeError."""
        lane = self._lanes.get(topic)
        best: list[Found] = []
        at = bisect_right(lane.starts, at_ns) if lane is not None else 0
        while lane is not None and at > 0:
            at -= 1
            if len(best) == most and lane.latest[at] <= best[0].time_ns:
                break  # no earlier block has a later one
            source, block = lane.places[at]
            times, keys = self._of(source, block, topic)
            end = bisect_right(times, at_ns)
            here = [Found(times[each], topic, keys[each], block, source) for each in range(max(0, end - most), end)]
            best = sorted(here + best, key=_TIME)[-most:]
        return best

    def first_after(self, topic: str, after_ns: int) -> Found | None:
        """The first message of a topic after a moment. Raises RuntimeError."""
        lane = self._lanes.get(topic)
        best: Found | None = None
        at = bisect_right(lane.latest, after_ns) if lane is not None else 0
        while lane is not None and at < len(lane.starts) and (best is None or lane.starts[at] < best.time_ns):
            source, block = lane.places[at]
            times, keys = self._of(source, block, topic)
            first = bisect_right(times, after_ns)
            if first < len(times) and (best is None or times[first] < best.time_ns):
                best = Found(times[first], topic, keys[first], block, source)
            at += 1
        return best

    def rate(self, topic: str) -> float | None:
        """Messages per second between the first and the last one; None for fewer than two, or all at once."""
        first, last = self.first_after(topic, -1), self.newest(topic, LATEST)
        if first is None or not last or last[0].time_ns <= first.time_ns:
            return None
        return (self.count(topic) - 1) * NANOSECONDS / (last[0].time_ns - first.time_ns)

    def next_time(self, topics: Iterable[str], after_ns: int) -> int | None:
        """When the next message of any of these topics was received; None after the last one."""
        found = [self.first_after(topic, after_ns) for topic in topics]
        return min((each.time_ns for each in found if each is not None), default=None)

    def previous_time(self, topics: Iterable[str], before_ns: int) -> int | None:
        """When the last message of any of these topics before a moment was received; None before the first one."""
        return max((each.time_ns for topic in topics for each in self.newest(topic, before_ns - 1)), default=None)

    def between(self, topics: Iterable[str], after_ns: int, until_ns: int) -> list[Found]:
        """The messages of these topics after one moment and until another, by time. Raises RuntimeError."""
        found: list[Found] = []
        for topic in topics:
            lane = self._lanes.get(topic)
            if lane is None:
                continue
            for at in range(bisect_right(lane.latest, after_ns), bisect_right(lane.starts, until_ns)):
                source, block = lane.places[at]
                times, keys = self._of(source, block, topic)
                first, end = bisect_right(times, after_ns), bisect_right(times, until_ns)
                found += [Found(times[each], topic, keys[each], block, source) for each in range(first, end)]
        return sorted(found, key=_TIME)

    def read(self, topics: Sequence[str], after_ns: int, until_ns: int) -> tuple[list[Passed], int]:
        """Read the messages after one moment, by time, until another or until there are enough; and until when that is.

        Raises RuntimeError.
        """
        while self.estimate(topics, after_ns, until_ns) > MOST_AT_ONCE and until_ns - after_ns > 1000:
            until_ns = (after_ns + until_ns) // 2
        passed: list[Passed] = []
        size = 0
        for found in self.between(topics, after_ns, until_ns):
            if size > MOST_BYTES and found.time_ns != passed[-1].found.time_ns:
                return passed, passed[-1].found.time_ns
            passed.append(Passed(found, found.read()))
            size += len(passed[-1].message.data)
        return passed, until_ns

    def _of(self, source: BagSource, block: Block, topic: str) -> Entries:
        return self._entries(source, block).get(topic) or _NOTHING

    def _entries(self, source: BagSource, block: Block) -> dict[str, Entries]:
        found = block.entries
        if found is None:
            found = source.entries(block)
        with self._keeping:
            block.entries = found
            self._kept[block] = None
            self._kept.move_to_end(block)
            while len(self._kept) > KEPT:
                self._kept.popitem(last=False)[0].entries = None
        return found


_TIME = attrgetter("time_ns", "block.number", "key")
"""By time; messages of the same time in the order of their file."""

_NO_TIMES: Sequence[int] = ()
_NOTHING = Entries(_NO_TIMES, _NO_TIMES)  # type: ignore[arg-type]
