"""`ros2 topic bw`."""

from __future__ import annotations

from argparse import ArgumentParser, Namespace
from collections import deque
from typing import TYPE_CHECKING

from day6_core.ros.differences import value
from day6_core.ros.ros2.cli.node import direct_node
from day6_core.ros.ros2.cli.options import add_discovery_options, add_qos_options, positive_int
from day6_core.ros.ros2.topic._several import add_topics, chosen_topics, clear_above, table

if TYPE_CHECKING:
    from day6_core.session.session import Session
    from rclpy.node import Node

SUMMARY = "Display bandwidth used by topic"
WINDOW = 100
_HEADER = ("topic", "bandwidth", "window", "mean", "min", "max")


def add_arguments(parser: ArgumentParser) -> None:
    several = value("topic.bw_of_several")
    words = "Topic name to monitor for bandwidth utilization"
    add_topics(parser, "topic", words, several=several, everything=several)
    add_qos_options(parser, "subscribe", "sensor_data")
    parser.add_argument(
        "--window",
        "-w",
        type=positive_int,
        default=WINDOW,
        metavar="WINDOW",
        help=f"maximum window size, in # of messages, for calculating rate (default: {WINDOW})",
    )
    add_discovery_options(parser)


async def main(session: Session, args: Namespace) -> None:
    from day6_core.ros.ros2.cli.message_class import wait_for_class
    from day6_core.ros.ros2.cli.qos import profile_for_measuring

    node = await direct_node(session, args)
    topics = await chosen_topics(session, node, args, "topic")
    meters: dict[str, _Meter] = {}
    for topic in topics:
        kind = await wait_for_class(session, node, topic)
        meters[topic] = _Meter(session, node, args.window)
        profile = profile_for_measuring(session, node, args, topic)
        node.create_subscription(kind, topic, meters[topic].count, profile, raw=True)
        session.print(f"Subscribed to [{topic}]")
    node.create_timer(1, lambda: _report(session, args, meters))
    await session.spin(node)


def _report(session: Session, args: Namespace, meters: dict[str, _Meter]) -> None:
    found = {topic: width for topic, meter in meters.items() if (width := meter.bandwidth()) is not None}
    if not found:
        return
    clear_above(session, args)
    if len(meters) > 1:
        session.print(table(_HEADER, [(topic, *width) for topic, width in found.items()]))
        return
    for speed, count, mean, smallest, largest in found.values():
        session.print(f"{speed} from {count} messages\n\tMessage size mean: {mean} min: {smallest} max: {largest}")


class _Meter:
    """The arrival times (nanoseconds) and sizes (bytes of CDR) of the last messages."""

    def __init__(self, session: Session, node: Node, window: int) -> None:
        self.session = session
        self.clock = node.get_clock()
        self.messages: deque[tuple[int, int]] = deque(maxlen=window)

    def count(self, data: bytes) -> None:
        self.messages.append((self.clock.now().nanoseconds, len(data)))

    def bandwidth(self) -> tuple[str, str, str, str, str] | None:
        """Return bandwidth, messages and their mean, smallest and largest size as they are shown; None for too few."""
        if len(self.messages) < 2:
            return None
        now, first = self.clock.now().nanoseconds, self.messages[0][0]
        if now <= first:
            self.session.print_error("WARNING: time is reset!")
            self.messages.clear()
            return None
        sizes = [size for _, size in self.messages]
        rate = sum(sizes) / ((now - first) * 1e-9)
        mean = sum(sizes) / len(sizes)
        # One unit for the whole line, chosen by the rate.
        speed, average, smallest, largest = (_amount(each, rate) for each in (rate, mean, min(sizes), max(sizes)))
        return f"{speed}/s", str(len(sizes)), average, smallest, largest


def _amount(size: float, rate: float) -> str:
    if rate < 1000:
        return f"{size:.0f} B"
    if rate < 1000000:
        return f"{size / 1000:.2f} KB"
    return f"{size / 1000 / 1000:.2f} MB"
