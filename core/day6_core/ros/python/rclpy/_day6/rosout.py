"""/rosout: every node's log messages as a topic.

A Log message is made only for a subscription (or the link); the records kept for late joiners stay plain tuples.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import Any, NamedTuple

from day6_core.graph import Node, Publisher, QoS
from rclpy._day6.handles import INVALID_PUBLISHER

TYPE_NAME = "rcl_interfaces/msg/Log"


class LogRecord(NamedTuple):
    """The fields of an rcl_interfaces/Log message; `stamp` is epoch nanoseconds."""

    stamp: int
    level: int
    name: str
    msg: str
    file: str
    function: str
    line: int


def to_message(record: LogRecord) -> Any:
    """Convert a record to a Log message."""
    from builtin_interfaces.msg import Time
    from rcl_interfaces.msg import Log

    seconds, nanoseconds = divmod(record.stamp, 1_000_000_000)
    return Log(
        stamp=Time(sec=seconds, nanosec=nanoseconds),
        level=record.level,
        name=record.name,
        msg=record.msg,
        file=record.file,
        function=record.function,
        line=record.line,
    )


class RosoutPublisher(Publisher):
    """The publisher of one node's log messages; `is_valid` returns whether the node's context is valid."""

    def __init__(self, node: Node, type_hash: str, qos: QoS, is_valid: Callable[[], bool]) -> None:
        copy: Callable[[Any], Any] = to_message
        super().__init__(node, "/rosout", TYPE_NAME, type_hash, qos, node.graph.new_gid(), copy)
        self.keep = lambda record: record  # nobody changes one, and most are never asked for
        self._is_valid = is_valid

    def log(
        self, stamp: int, severity: int, name: str, message: str, file: str, function: str, line: int
    ) -> str | None:
        """Send one message. Returns the reason if that failed, else None."""
        if not self._is_valid():
            return INVALID_PUBLISHER
        if not self.destroyed:
            self.publish(LogRecord(stamp, severity, name, message, file, function, line))
        return None

    def publish(self, message: Any) -> None:
        """Deliver a record here, and a message to other processes."""
        graph = self.node.graph
        source_timestamp = graph.now_ns()
        number = next(self._numbers)
        self.deliver(message, source_timestamp, number)
        if graph.transport is not None:
            graph.transport.publish(self, to_message(message), source_timestamp, number)
