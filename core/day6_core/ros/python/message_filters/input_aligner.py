"""Puts the messages of several filters into the order of their times."""

from __future__ import annotations

import heapq
import threading
from collections.abc import Callable
from dataclasses import dataclass
from typing import Any

from message_filters.simple_filter import SimpleFilter
from rclpy.clock_type import ClockType
from rclpy.duration import Duration
from rclpy.node import Node
from rclpy.time import Time

_NEVER = Time(nanoseconds=2**63 - 1, clock_type=ClockType.ROS_TIME)


@dataclass
class QueueStatus:
    """The state of an input: whether it is waited for, how many of its messages wait, went through, and came too late."""

    active: bool
    queue_size: int
    msgs_processed: int
    msgs_dropped: int


class _Input:
    """The waiting messages of one input."""

    def __init__(self) -> None:
        self.signal = SimpleFilter()
        self.waiting: list[tuple[int, int, Time, Any]] = []
        self.period = Duration()
        self.active = False
        self.processed = 0
        self.dropped = 0
        self._next = _NEVER
        self._count = 0

    def add(self, stamp: Time, message: Any) -> None:
        heapq.heappush(self.waiting, (stamp.nanoseconds, self._count, stamp, message))
        self._count += 1

    def first_time(self) -> Time:
        """Return the time of the first message that waits, or else of the one that is expected."""
        if self.waiting:
            stamp = self.waiting[0][2]
            self._next = stamp + self.period
            self.active = True
            return stamp
        return self._next if self.active else _NEVER


class InputAligner(SimpleFilter):
    """Passes the messages of its inputs on by time, each to the callbacks that are registered for its input.

    A message waits while another input may still have an earlier one: until that input has been silent for `timeout` of the
    messages' time. What is earlier than what has been passed on is dropped.
    """

    def __init__(self, timeout: Duration, *filters: SimpleFilter) -> None:
        SimpleFilter.__init__(self)
        self.timeout = timeout
        self.last_in_ts = self.last_out_ts = Time(clock_type=ClockType.ROS_TIME)
        self.name = ""
        self.lock = threading.Lock()
        self.event_queues: list[_Input] = []
        self.input_connections: list[tuple[SimpleFilter, int]] = []
        self.dispatch_timer: Any = None
        if filters:
            self.connectInput(*filters)

    def connectInput(self, *filters: SimpleFilter) -> None:
        """Connect to the filters' outputs, to no others."""
        with self.lock:
            self.disconnectAll()
            self.event_queues = [_Input() for _ in filters]
            self.input_connections = [
                (each, each.registerCallback(self.add, number)) for number, each in enumerate(filters)
            ]

    def disconnectAll(self) -> None:
        """Let go of all inputs."""
        for each, connection in self.input_connections:
            each.unregisterCallback(connection)
        self.input_connections = []

    def registerCallback(self, index: int, callback: Callable[..., Any], *args: Any) -> int:  # type: ignore[override]
        """Call `callback(message, *args)` for the messages of one input."""
        return self.event_queues[index].signal.registerCallback(callback, *args)

    def setName(self, name: str) -> None:
        """Give this filter a name."""
        self.name = name

    def getName(self) -> str:
        """Return the name that was given."""
        return self.name

    def add(self, msg: Any, queue_index: int) -> None:
        """Receive a message of one input."""
        stamp = Time.from_msg(msg.header.stamp)
        with self.lock:
            queue = self.event_queues[queue_index]
            if stamp < self.last_out_ts:
                queue.dropped += 1
                return
            self.last_in_ts = max(self.last_in_ts, stamp)
            queue.add(stamp, msg)

    def setInputPeriod(self, index: int, period: Duration) -> None:
        """Say how far apart the messages of an input are, so that the next one is expected."""
        self.event_queues[index].period = period

    def getQueueStatus(self, index: int) -> QueueStatus:
        """Return the state of an input."""
        queue = self.event_queues[index]
        return QueueStatus(queue.active, len(queue.waiting), queue.processed, queue.dropped)

    def setupDispatchTimer(self, node: Node, update_rate: Duration) -> None:
        """Call `dispatchMessages` regularly, by a timer of a node."""
        self.dispatch_timer = node.create_timer(update_rate.nanoseconds / 1e9, self.dispatchMessages)

    def dispatchMessages(self) -> None:
        """Pass on what waits for nothing any more."""
        with self.lock:
            if any(queue.waiting for queue in self.event_queues):
                while self._dispatch_first():
                    pass

    def _dispatch_first(self) -> bool:
        queue = min(self.event_queues, key=lambda each: each.first_time().nanoseconds)
        if queue.waiting:
            _, _, self.last_out_ts, message = queue.waiting[0]
            queue.signal.signalMessage(message)
            heapq.heappop(queue.waiting)
            queue.processed += 1
            return True
        if self.last_in_ts - queue.first_time() >= self.timeout:
            queue.active = False
            return True
        return False
