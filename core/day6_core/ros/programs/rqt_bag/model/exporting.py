"""Copies a part of the open bags into a new bag. It belongs into a thread."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Sequence
from pathlib import Path

from rosbag2_py._console import quiet
from rosbag2_py._storage import StorageOptions
from rosbag2_py._writer import SequentialWriter

from day6_core.reason import reason
from day6_core.ros.programs.rqt_bag.model.loading import OpenBag
from day6_core.ros.programs.rqt_bag.model.timeline import Timeline


class ExportError(Exception):
    """Why nothing, or not everything, was copied: in the words of rqt_bag."""


def export(
    timeline: Timeline,
    bags: Sequence[OpenBag],
    path: Path,
    topics: Iterable[str],
    begin_ns: int,
    end_ns: int,
    progress: Callable[[int], object],
    cancelled: Callable[[], bool],
) -> int:
    """Copy the messages of topics in a time to a new bag of the default storage; returns how many.

    `progress` gets per cent. A bag that was cancelled has what was copied until then.

    Raises:
        ExportError: there is nothing to copy, the bag exists, or it can't be read or written.
    """
    chosen = list(topics)
    first = timeline.next_time(chosen, begin_ns - 1)
    if first is None or first > end_ns:
        raise ExportError("No messages found")
    writer = SequentialWriter(quiet)
    try:
        writer.open(StorageOptions(str(path)))
    except (RuntimeError, OSError) as error:
        raise ExportError(f"Error opening bag file [{path}] for writing: {reason(error)}") from None
    count, after = 0, begin_ns - 1
    try:
        for bag in reversed(bags):
            for topic in bag.topics.values():
                if topic.name in chosen:
                    writer.create_topic(topic, bag.definitions.get(topic.type))
        while after < end_ns and not cancelled():
            passed, after = timeline.read(chosen, after, end_ns)
            for _, message in passed:
                writer.write(message.topic, message.data, message.received_ns, message.sent_ns or None)
            count += len(passed)
            progress(100 * (after - begin_ns) // max(1, end_ns - begin_ns))
        writer.close()
    except (RuntimeError, OSError) as error:
        raise ExportError(f"Error exporting message at position {after}: {reason(error)}") from None
    return count
