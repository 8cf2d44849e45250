"""What the synchronizers behind a node's subscriptions have, and why nothing may come of it: for day6-tui's inspector."""

from __future__ import annotations

from collections.abc import Iterator
from itertools import combinations
from typing import TYPE_CHECKING, Any

import message_filters as filters

if TYPE_CHECKING:
    from rclpy.node import Node


def of_synchronizers(node: Node) -> Iterator[dict[str, Any]]:
    """Yield for each synchronizer its inputs with the messages of each, matches, and how the times lie that it keeps."""
    inputs: dict[Any, dict[int, Any]] = {}
    for subscription in list(node._rclpy_entities.subscriptions):
        behind = getattr(subscription.callback, "__self__", None)
        if isinstance(behind, filters.SimpleFilter):
            for synchronizer, number in _synchronizers(behind, set()):
                inputs.setdefault(synchronizer, {})[number] = subscription._endpoint
    for synchronizer, ends in inputs.items():
        yield _of_one(synchronizer, [ends[number] for number in sorted(ends)])


def _synchronizers(behind: Any, seen: set[int]) -> Iterator[tuple[Any, int]]:
    """The synchronizers that a filter leads to, through others as well, each with the number of the input."""
    if id(behind) in seen:
        return
    seen.add(id(behind))
    for callback, arguments in list(behind.callbacks.values()):
        owner = getattr(callback, "__self__", None)
        if isinstance(owner, filters.TimeSynchronizer) and len(arguments) == 2:
            yield owner, arguments[1]
        elif isinstance(owner, filters.SimpleFilter):
            yield from _synchronizers(owner, seen)


def _of_one(synchronizer: Any, ends: list[Any]) -> dict[str, Any]:
    slop = getattr(synchronizer, "slop", None)  # only an approximate one has it
    # Without its lock, which it holds while it calls back: a callback may stay for ever, and wait for the link's thread.
    times = [] if synchronizer._matches else [sorted(queue.copy()) for queue in synchronizer.queues]
    gap, shorter = _nearest(times, synchronizer.queue_size)
    silent = [end for end in ends if not end.received]
    return {
        "topics": ", ".join(end.topic for end in ends),
        "silent": ", ".join(end.topic for end in silent),
        "unpublished": sum(not end.publisher_count for end in silent),
        "least": min((int(end.received) for end in ends), default=0),
        "most": max((int(end.received) for end in ends), default=0),
        "matches": synchronizer._matches,
        "timeless": synchronizer._timeless,
        "callbacks": len(synchronizer.callbacks),
        "slop": slop.nanoseconds / 1e9 if slop is not None else 0.0,
        "queue_size": synchronizer.queue_size,
        "gap": gap / 1e9,
        "short": ends[shorter].topic if 0 <= shorter < len(ends) else "",
    }


def _nearest(times: list[list[int]], size: int) -> tuple[int, int]:
    """The largest distance (ns) between what is nearest in two of the inputs.

    Also the input of these that is full and has nothing so old any more, -1 if there is none.
    """
    worst, short = 0, -1
    for (number, one), (another, other) in combinations(enumerate(times), 2):
        if one and other:
            distance = min(abs(each - theirs) for each in one for theirs in other)
            if distance > worst:
                worst, short = distance, -1
                if one[-1] < other[0] and len(other) >= size:
                    short = another
                elif other[-1] < one[0] and len(one) >= size:
                    short = number
    return worst, short
