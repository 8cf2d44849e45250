"""The ROS package message_filters: synchronizes messages of several topics by the times in their headers."""

from __future__ import annotations

import itertools
import threading
from collections.abc import Callable, Sequence
from typing import Any

import rclpy.logging
from rclpy.clock import ROSClock
from rclpy.duration import Duration
from rclpy.logging import LoggingSeverity
from rclpy.time import Time

_HEADERLESS = (
    "can not use message filters messages without timestamp infomation when "
    '"allow_headerless" is disabled. auto assign ROSTIME to headerless '
    'messages once enabling constructor option of "allow_headerless".'
)


def _stamp_of(message: Any, allow_headerless: bool, logger: str) -> Time | None:
    """Return a message's stamp, without a header the current time; None, with a warning, if that isn't allowed."""
    if hasattr(message, "header") and hasattr(message.header, "stamp"):
        stamp = message.header.stamp
        return stamp if hasattr(stamp, "nanoseconds") else Time.from_msg(stamp)
    if allow_headerless:
        return ROSClock().now()
    log = rclpy.logging.get_logger(logger)
    log.set_level(LoggingSeverity.INFO)
    log.warning(_HEADERLESS)
    return None


class SimpleFilter:
    """Base of all filters: passes messages on to its registered callbacks."""

    def __init__(self) -> None:
        self.callbacks: dict[int, tuple[Callable[..., Any], tuple[Any, ...]]] = {}

    def registerCallback(self, cb: Callable[..., Any], *args: Any) -> int:
        """Call `cb(message…, *args)` for every output of this filter. Returns the connection's number."""
        connection = len(self.callbacks)
        self.callbacks[connection] = (cb, args)
        return connection

    def signalMessage(self, *msg: Any) -> None:
        """Pass messages on."""
        for callback, args in self.callbacks.values():
            callback(*msg, *args)


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

    def __init__(self, f: SimpleFilter, cache_size: int = 1, allow_headerless: bool = False) -> None:
        SimpleFilter.__init__(self)
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
        stamp = _stamp_of(msg, self.allow_headerless, "message_filters_cache")
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

    def getLastestTime(self) -> Time | None:
        """Return the time of the last message, None if there is none."""
        return self.cache_times[-1] if self.cache_times else None

    def getOldestTime(self) -> Time | None:
        """Return the time of the first message, None if there is none."""
        return self.cache_times[0] if self.cache_times else None

    def getLast(self) -> Any:
        """Return the last message, None if there is none."""
        latest = self.getLastestTime()
        return None if latest is None else self.getElemAfterTime(latest)


class TimeSynchronizer(SimpleFilter):
    """Calls `callback(msg1, … msgN)` when all N filters have a message with exactly the same time.

    `queue_size` is the number of messages of each filter that wait for the others.
    """

    def __init__(self, fs: Sequence[SimpleFilter], queue_size: int) -> None:
        SimpleFilter.__init__(self)
        self.connectInput(fs)
        self.queue_size = queue_size
        self.lock = threading.Lock()

    def connectInput(self, fs: Sequence[SimpleFilter]) -> None:
        """Connect to the filters' outputs."""
        self.queues: list[dict[int, Any]] = [{} for _ in fs]
        self.input_connections = [
            each.registerCallback(self.add, queue, number)
            for number, (each, queue) in enumerate(zip(fs, self.queues, strict=True))
        ]

    def add(self, msg: Any, my_queue: dict[int, Any], my_queue_index: int | None = None) -> None:
        """Receive a message of the filter with the queue `my_queue`."""
        with self.lock:
            self._keep(msg, Time.from_msg(msg.header.stamp), my_queue)
            common = set(self.queues[0]).intersection(*self.queues[1:])
            for stamp in sorted(common):
                self.signalMessage(*(queue[stamp] for queue in self.queues))
                for queue in self.queues:
                    del queue[stamp]

    def _keep(self, msg: Any, stamp: Time, queue: dict[int, Any]) -> None:
        queue[stamp.nanoseconds] = msg
        while len(queue) > self.queue_size:
            del queue[min(queue)]


class ApproximateTimeSynchronizer(TimeSynchronizer):
    """Like TimeSynchronizer, but the times may differ by up to `slop` seconds. A message is matched with the nearest ones."""

    def __init__(
        self, fs: Sequence[SimpleFilter], queue_size: int, slop: float, allow_headerless: bool = False
    ) -> None:
        TimeSynchronizer.__init__(self, fs, queue_size)
        self.slop = Duration(seconds=slop)
        self.allow_headerless = allow_headerless

    def add(self, msg: Any, my_queue: dict[int, Any], my_queue_index: int | None = None) -> None:
        """Receive a message of the filter with the queue `my_queue` and its index."""
        stamp = _stamp_of(msg, self.allow_headerless, "message_filters_approx")
        if stamp is None:
            return
        with self.lock:
            self._keep(msg, stamp, my_queue)
            chosen = self._nearest(stamp.nanoseconds, my_queue_index)
            if chosen is not None:
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
