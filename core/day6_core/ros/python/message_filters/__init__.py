"""The ROS package message_filters: synchronizes messages of several topics by the times in their headers."""

from __future__ import annotations

import itertools
import threading
from bisect import bisect_right
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

import rclpy.logging
from day6_core.sign_sources import sources
from message_filters.message_traits import get_time_from_message_header
from message_filters.simple_filter import SimpleFilter as SimpleFilter
from rclpy.clock import ROSClock
from rclpy.duration import Duration
from rclpy.logging import LoggingSeverity
from rclpy.time import Time

if TYPE_CHECKING:
    from collections.abc import Iterator

    from rclpy.node import Node

_LATER = {
    "delta_filter": "CachedComparisonHandler ComparisonFilter ComparisonHandler DeltaCompare DeltaFilter PathDeltaFilter",
    "input_aligner": "InputAligner QueueStatus",
}
"""Modules with names of this package that are imported when they are used."""


def __getattr__(name: str) -> Any:
    for module, names in _LATER.items():
        if name in names.split():
            from importlib import import_module

            return getattr(import_module(f"{__name__}.{module}"), name)
    raise AttributeError(f"module {__name__!r} has no attribute {name!r}")


def _signs(node: Node) -> Iterator[dict[str, Any]]:
    from message_filters._signs import of_synchronizers

    return of_synchronizers(node)


sources["sync"] = _signs

_HEADERLESS = (
    "can not use message filters messages without timestamp infomation when "
    '"allow_headerless" is disabled. auto assign ROSTIME to headerless '
    'messages once enabling constructor option of "allow_headerless".'
)


TimeGetter = Callable[[Any], "Time | None"]


def _stamp_of(message: Any, time_getter: TimeGetter, allow_headerless: bool, logger: str) -> Time | None:
    """Return a message's time, without one the current time; None, with a warning, if that isn't allowed."""
    stamp = time_getter(message)
    if stamp is not None:
        return stamp
    if allow_headerless:
        return ROSClock().now()
    log = rclpy.logging.get_logger(logger)
    log.set_level(LoggingSeverity.INFO)
    log.warning(_HEADERLESS)
    return None


class Subscriber(SimpleFilter):
    """A subscription as a filter: `Subscriber(node, message_class, topic, …)`; the rest is as in `create_subscription`."""

    def __init__(self, *args: Any, **kwargs: Any) -> None:
        SimpleFilter.__init__(self)
        self.node = args[0]
        self.topic = args[2]
        kwargs.setdefault("qos_profile", 10)
        self.sub = self.node.create_subscription(*args[1:], self.callback, **kwargs)

    def callback(self, msg: Any) -> None:
        """Receive a message of the topic."""
        self.signalMessage(msg)

    def getTopic(self) -> str:
        """Return the topic's name as given."""
        topic: str = self.topic
        return topic

    def __getattr__(self, key: str) -> Any:
        """Return the subscription's attribute of this name."""
        if key == "sub":
            raise AttributeError(key)
        return getattr(self.sub, key)


class Cache(SimpleFilter):
    """Keeps the last `cache_size` messages of a filter, in the order of their arrival, for lookups by time."""

    def __init__(
        self,
        f: SimpleFilter,
        cache_size: int = 1,
        allow_headerless: bool = False,
        time_getter: TimeGetter = get_time_from_message_header,
    ) -> None:
        SimpleFilter.__init__(self)
        self.time_getter = time_getter
        self.connectInput(f)
        self.cache_size = cache_size
        self.cache_msgs: list[Any] = []
        self.cache_times: list[Time] = []
        self.allow_headerless = allow_headerless

    def connectInput(self, f: SimpleFilter) -> None:
        """Connect to a filter's output."""
        self.incoming_connection = f.registerCallback(self.add)

    def add(self, msg: Any) -> None:
        """Store a message and pass it on."""
        stamp = _stamp_of(msg, self.time_getter, self.allow_headerless, "message_filters_cache")
        if stamp is None:
            return
        self.cache_times.append(stamp)
        self.cache_msgs.append(msg)
        if len(self.cache_msgs) > self.cache_size:
            del self.cache_msgs[0]
            del self.cache_times[0]
        self.signalMessage(msg)

    def _where(self, condition: Callable[[Time], bool]) -> list[Any]:
        return [msg for msg, time in zip(self.cache_msgs, self.cache_times, strict=True) if condition(time)]

    def getInterval(self, from_stamp: Time, to_stamp: Time) -> list[Any]:
        """Return the messages between two times, inclusive."""
        assert from_stamp <= to_stamp
        return self._where(lambda time: from_stamp <= time <= to_stamp)

    def getElemAfterTime(self, stamp: Time) -> Any:
        """Return the first message at or after a time, None if there is none."""
        return next(iter(self._where(lambda time: time >= stamp)), None)

    def getElemBeforeTime(self, stamp: Time) -> Any:
        """Return the last message at or before a time, None if there is none."""
        return next(reversed(self._where(lambda time: time <= stamp)), None)

    def getLatestTime(self) -> Time | None:
        """Return the time of the last message, None if there is none."""
        return self.cache_times[-1] if self.cache_times else None

    def getLastestTime(self) -> Time | None:
        """Return the time of the last message, under the name that this had for long."""
        return self.getLatestTime()

    def getOldestTime(self) -> Time | None:
        """Return the time of the first message, None if there is none."""
        return self.cache_times[0] if self.cache_times else None

    def getLast(self) -> Any:
        """Return the last message, None if there is none."""
        latest = self.getLatestTime()
        return None if latest is None else self.getElemAfterTime(latest)


class Chain(SimpleFilter):
    """Several filters behind one another, as one filter; without any, messages just pass."""

    @dataclass
    class FilterInfo:
        """A filter of the chain, and the number of its connection to what comes behind it."""

        message_filter: Any
        connection_callback_index: int

    def __init__(self, message_filter: SimpleFilter | None = None) -> None:
        SimpleFilter.__init__(self)
        self.incoming_connection: int | None = None
        self._message_filters: dict[int, Chain.FilterInfo] = {}
        if message_filter is not None:
            self.connectInput(message_filter)

    def connectInput(self, message_filter: SimpleFilter) -> None:
        """Connect to a filter's output. Raises RuntimeError if it is connected already."""
        if self.incoming_connection is not None:
            raise RuntimeError("Already connected")
        self.incoming_connection = message_filter.registerCallback(self.add)

    def add(self, message: Any) -> None:
        """Receive a message."""
        if self._message_filters:
            self._message_filters[0].message_filter.add(message)
        else:
            self.signalMessage(message)

    def addFilter(self, message_filter: Any) -> None:
        """Put a filter behind the others."""
        count = len(self._message_filters)
        if count:
            last = self._message_filters[count - 1]
            last.message_filter.unregisterCallback(last.connection_callback_index)
            last.connection_callback_index = last.message_filter.registerCallback(message_filter.add)
        self._message_filters[count] = Chain.FilterInfo(
            message_filter, message_filter.registerCallback(self.signalMessage)
        )

    def getFilter(self, index: int) -> Any:
        """Return a filter of the chain."""
        return self._message_filters[index].message_filter


class TimeSynchronizer(SimpleFilter):
    """Calls `callback(msg1, … msgN)` when all N filters have a message with exactly the same time.

    `queue_size` is the number of messages of each filter that wait for the others. What is older than messages that went
    together is dropped.
    """

    def __init__(
        self,
        fs: Sequence[SimpleFilter],
        queue_size: int,
        time_getter: TimeGetter = get_time_from_message_header,
    ) -> None:
        SimpleFilter.__init__(self)
        self.time_getter = time_getter
        self.connectInput(fs)
        self.queue_size = queue_size
        self.lock = threading.Lock()
        self._matches = 0
        self._timeless = 0
        """Matches that were found, and messages without a time, for the inspector."""

    def connectInput(self, fs: Sequence[SimpleFilter]) -> None:
        """Connect to the filters' outputs."""
        self.queues: list[dict[int, Any]] = [{} for _ in fs]
        self.input_connections = [
            each.registerCallback(self.add, queue, number)
            for number, (each, queue) in enumerate(zip(fs, self.queues, strict=True))
        ]

    def add(self, msg: Any, my_queue: dict[int, Any], my_queue_index: int | None = None) -> None:
        """Receive a message of the filter with the queue `my_queue`."""
        stamp = self.time_getter(msg)
        with self.lock:
            self._keep(msg, (stamp or Time.from_msg(msg.header.stamp)).nanoseconds, my_queue)
            common = set(self.queues[0]).intersection(*self.queues[1:])
            if not common:
                return
            together = min(common)
            self._matches += 1
            self.signalMessage(*(queue[together] for queue in self.queues))
            for queue in self.queues:
                for time in [time for time in queue if time <= together]:
                    del queue[time]

    def _keep(self, msg: Any, stamp: int, queue: dict[int, Any]) -> None:
        queue[stamp] = msg
        while len(queue) > self.queue_size:
            del queue[min(queue)]


class ApproximateTimeSynchronizer(TimeSynchronizer):
    """Like TimeSynchronizer, but the times may differ by up to `slop` seconds. A message is matched with the nearest ones.

    `queue_offset` has the nanoseconds by which each filter is late. With `sync_arrival_time` the current time counts.
    """

    def __init__(
        self,
        fs: Sequence[SimpleFilter],
        queue_size: int,
        slop: float,
        queue_offset: Sequence[int] | bool = False,
        allow_headerless: bool = False,
        sync_arrival_time: bool = False,
        time_getter: TimeGetter = get_time_from_message_header,
    ) -> None:
        TimeSynchronizer.__init__(self, fs, queue_size, time_getter)
        self.slop = Duration(seconds=slop)
        # Before message_filters#154 the fourth argument was allow_headerless.
        self.allow_headerless = allow_headerless or queue_offset is True
        self.queue_offset = () if isinstance(queue_offset, bool) else queue_offset
        self.sync_arrival_time = sync_arrival_time

    def add(self, msg: Any, my_queue: dict[int, Any], my_queue_index: int | None = None) -> None:
        """Receive a message of the filter with the queue `my_queue` and its index."""
        stamp = (
            ROSClock().now()
            if self.sync_arrival_time
            else _stamp_of(msg, self.time_getter, self.allow_headerless, "message_filters_approx")
        )
        if stamp is None:
            self._timeless += 1
            return
        time = stamp.nanoseconds
        if my_queue_index is not None and self.queue_offset:
            time -= self.queue_offset[my_queue_index]
        with self.lock:
            self._keep(msg, time, my_queue)
            chosen = self._nearest(time, my_queue_index)
            if chosen is not None:
                self._matches += 1
                self.signalMessage(*(queue[time] for queue, time in zip(self.queues, chosen, strict=True)))
                for queue, time in zip(self.queues, chosen, strict=True):
                    del queue[time]

    def _nearest(self, stamp: int, index: int | None) -> list[int] | None:
        """Return for each queue the time (ns) that matches `stamp` of the queue `index`; None if there is no match."""
        slop = self.slop.nanoseconds
        candidates = []
        for number, queue in enumerate(self.queues):
            if number == index:
                continue
            near = [time for time in queue if abs(time - stamp) <= slop]
            if not near:
                return None
            candidates.append(sorted(near, key=lambda time: abs(time - stamp)))
        for choice in itertools.product(*candidates):
            times = list(choice)
            if index is not None:
                times.insert(index, stamp)
            if max(times) - min(times) < slop and all(
                time in queue for queue, time in zip(self.queues, times, strict=True)
            ):
                return times
        return None


class TimeSequencer(SimpleFilter):
    """Passes messages on in the order of their times, each when it is `delay` old; what comes too late for that is dropped.

    `msg_stamp_attr` is where the time is; `delay` and `update_rate` (how often it is looked) are Durations or seconds.
    """

    def __init__(
        self,
        input_filter: SimpleFilter | None,
        delay: Duration | float,
        update_rate: Duration | float,
        queue_size: int,
        node: Node,
        msg_stamp_attr: str = "header.stamp",
    ) -> None:
        super().__init__()
        self.delay = delay if isinstance(delay, Duration) else Duration(seconds=delay)
        self.update_rate = update_rate if isinstance(update_rate, Duration) else Duration(seconds=update_rate)
        self.queue_size = queue_size
        self.lock = threading.Lock()
        self.messages: list[tuple[int, Any]] = []
        self.last_time = 0
        self.node = node
        self.msg_stamp_attrs = msg_stamp_attr.split(".")
        self.update_timer = node.create_timer(self.update_rate.nanoseconds / 1e9, self._dispatch)
        self.incoming_connection: int | None = None
        if input_filter is not None:
            self.connectInput(input_filter)

    def connectInput(self, input_filter: SimpleFilter) -> None:
        """Connect to a filter's output. Raises RuntimeError if it is connected already."""
        if self.incoming_connection is not None:
            raise RuntimeError("Already connected to an input filter.")
        self.incoming_connection = input_filter.registerCallback(self._add)

    def _add(self, msg: Any) -> None:
        stamp = self._time_of(msg)
        with self.lock:
            if stamp is None or stamp < self.last_time:
                return
            place = bisect_right([time for time, _ in self.messages], stamp)
            self.messages.insert(place, (stamp, msg))
            if self.queue_size and len(self.messages) > self.queue_size:
                del self.messages[0]

    def _time_of(self, msg: Any) -> int | None:
        stamp = msg
        for name in self.msg_stamp_attrs:
            stamp = getattr(stamp, name, None)
        if stamp is None:
            self.node.get_logger().warning("Cannot use message without timestamp; discarding message.")
            return None
        from builtin_interfaces.msg import Time as TimeMsg

        if not isinstance(stamp, TimeMsg):
            place = ".".join(self.msg_stamp_attrs)
            raise TypeError(f"Expected {TimeMsg}, got {type(stamp)} in msg attribute '{place}'")
        return Time.from_msg(stamp).nanoseconds

    def _dispatch(self) -> None:
        now = self.node.get_clock().now().nanoseconds
        with self.lock:
            due = [each for each in self.messages if each[0] + self.delay.nanoseconds <= now]
            del self.messages[: len(due)]
            if due:
                self.last_time = due[-1][0]
        for _, message in due:
            self.signalMessage(message)

    def shutdown(self) -> None:
        """End the timer."""
        self.update_timer.cancel()
        self.node.destroy_timer(self.update_timer)
