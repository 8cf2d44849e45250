"""`ros2 topic delay`."""

from __future__ import annotations

import math
from argparse import ArgumentParser, Namespace
from typing import TYPE_CHECKING, Any

from day6_core.ros.ros2.cli.completion import topic_names
from day6_core.ros.ros2.cli.node import direct_node
from day6_core.ros.ros2.cli.options import add_discovery_options, add_qos_options, completed, positive_int

if TYPE_CHECKING:
    from day6_core.session.session import Session
    from rclpy.node import Node

SUMMARY = "Display delay of topic from timestamp in header"
WINDOW = 10000


def add_arguments(parser: ArgumentParser) -> None:
    completed(parser.add_argument("topic", help="Topic name to calculate the delay for"), topic_names)
    add_qos_options(parser, "subscribe", "sensor_data")
    parser.add_argument(
        "--window",
        "-w",
        type=positive_int,
        default=WINDOW,
        help=f"window size, in # of messages, for calculating rate, string to (default: {WINDOW})",
    )
    add_discovery_options(parser)


async def main(session: Session, args: Namespace) -> None:
    from day6_core.ros.ros2.cli.message_class import wait_for_class
    from day6_core.ros.ros2.cli.qos import profile_for_measuring

    node = await direct_node(session, args)
    kind = await wait_for_class(session, node, args.topic)
    meter = _Meter(session, node, args.window)
    node.create_subscription(kind, args.topic, meter.count, profile_for_measuring(session, node, args, args.topic))
    node.create_timer(1, meter.report)
    await session.spin(node)


class _Meter:
    """Collects the delays between messages' stamps and their arrival, in nanoseconds."""

    def __init__(self, session: Session, node: Node, window: int) -> None:
        self.session = session
        self.clock = node.get_clock()
        self.window = window
        self.first = -1
        self.last = 0
        self.reported = 0
        self.delays: list[int] = []

    def count(self, message: Any) -> None:
        if not hasattr(message, "header"):
            raise RuntimeError("msg does not have header")
        now = self.clock.now().nanoseconds
        if now == 0:
            if self.delays:
                self.session.print("time has reset, resetting counters")
                self.delays = []
            return
        if self.first < 0 or self.first > now:
            self.first = now
            self.delays = []
        else:
            stamp = message.header.stamp
            self.delays.append(now - (stamp.sec * 1_000_000_000 + stamp.nanosec))
            if len(self.delays) > self.window:
                self.delays.pop(0)
        self.last = now

    def report(self) -> None:
        if not self.delays:
            return
        if self.last == self.reported:
            self.session.print("no new messages")
            return
        self.reported = self.last
        number = len(self.delays)
        mean = sum(self.delays) / number
        deviation = math.sqrt(sum((delay - mean) ** 2 for delay in self.delays) / number)
        self.session.print(
            f"average delay: {mean * 1e-9:.3f}\n\tmin: {min(self.delays) * 1e-9:.3f}s max: {max(self.delays) * 1e-9:.3f}s "
            f"std dev: {deviation * 1e-9:.5f}s window: {number}"
        )
