"""`ros2 topic bw`."""

from __future__ import annotations

from argparse import ArgumentParser, Namespace
from collections import deque
from typing import TYPE_CHECKING

from day6_tui.core.ros.ros2.cli.completion import topic_names
from day6_tui.core.ros.ros2.cli.node import direct_node
from day6_tui.core.ros.ros2.cli.options import add_discovery_options, completed, positive_int

if TYPE_CHECKING:
    from day6_tui.core.session.session import Session
    from rclpy.node import Node

SUMMARY = "Display bandwidth used by topic"
WINDOW = 100


def add_arguments(parser: ArgumentParser) -> None:
    completed(parser.add_argument("topic", help="Topic name to monitor for bandwidth utilization"), topic_names)
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
    from day6_tui.core.ros.ros2.topic._types import wait_for_class
    from rclpy.qos import qos_profile_sensor_data

    node = await direct_node(session, args)
    kind = await wait_for_class(session, node, args.topic)
    meter = _Meter(session, node, args.window)
    node.create_subscription(kind, args.topic, meter.count, qos_profile_sensor_data, raw=True)
    session.print(f"Subscribed to [{args.topic}]")
    node.create_timer(1, meter.report)
    await session.spin(node)


class _Meter:
    """The arrival times (nanoseconds) and sizes (bytes of CDR) of the last messages."""

    def __init__(self, session: Session, node: Node, window: int) -> None:
        self.session = session
        self.clock = node.get_clock()
        self.messages: deque[tuple[int, int]] = deque(maxlen=window)

    def count(self, data: bytes) -> None:
        self.messages.append((self.clock.now().nanoseconds, len(data)))

    def report(self) -> None:
        if len(self.messages) < 2:
            return
        now, first = self.clock.now().nanoseconds, self.messages[0][0]
        if now <= first:
            self.session.print_error("WARNING: time is reset!")
            self.messages.clear()
            return
        sizes = [size for _, size in self.messages]
        rate = sum(sizes) / ((now - first) * 1e-9)
        mean = sum(sizes) / len(sizes)
        # One unit for the whole line, chosen by the rate.
        speed, average, smallest, largest = (_amount(value, rate) for value in (rate, mean, min(sizes), max(sizes)))
        self.session.print(
            f"{speed}/s from {len(sizes)} messages\n\tMessage size mean: {average} min: {smallest} max: {largest}"
        )


def _amount(size: float, rate: float) -> str:
    if rate < 1000:
        return f"{size:.0f} B"
    if rate < 1000000:
        return f"{size / 1000:.2f} KB"
    return f"{size / 1000 / 1000:.2f} MB"
