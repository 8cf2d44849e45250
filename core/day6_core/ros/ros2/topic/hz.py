"""`ros2 topic hz`."""

from __future__ import annotations

import math
from argparse import ArgumentParser, Namespace
from functools import partial
from typing import TYPE_CHECKING, Any, NamedTuple

from day6_core.ros.differences import value
from day6_core.ros.ros2.cli.node import direct_node
from day6_core.ros.ros2.cli.options import add_discovery_options, add_qos_options, positive_int
from day6_core.ros.ros2.topic._several import add_topics, chosen_topics, clear_above, table

if TYPE_CHECKING:
    from collections.abc import Callable

    from day6_core.session.session import Session

SUMMARY = "Print the average publishing rate to screen"
WINDOW = 10000
_HEADER = ("topic", "rate", "min_delta", "max_delta", "std_dev", "window")


def add_arguments(parser: ArgumentParser) -> None:
    words = "Names of the ROS topic to listen to (e.g. '/chatter')"
    add_topics(parser, "topic_name", words, several=True, everything=value("topic.hz_of_all"))
    add_qos_options(parser, "subscribe", "sensor_data")
    parser.add_argument(
        "--window",
        "-w",
        dest="window_size",
        metavar="WINDOW",
        type=positive_int,
        default=WINDOW,
        help=f"window size, in # of messages, for calculating rate (default: {WINDOW})",
    )
    parser.add_argument(
        "--filter",
        dest="filter_expr",
        metavar="EXPR",
        help="only measure messages matching the specified Python expression",
    )
    parser.add_argument(
        "--wall-time",
        dest="use_wtime",
        action="store_true",
        help="calculates rate using wall time which can be helpful when clock is not published during simulation",
    )
    add_discovery_options(parser)


async def main(session: Session, args: Namespace) -> None:
    from day6_core.ros.ros2.cli.message_class import wait_for_class
    from day6_core.ros.ros2.cli.qos import profile_for_measuring
    from rclpy.executors import ExternalShutdownException

    node = await direct_node(session, args)
    now_ns = session.clock.now_ns if args.use_wtime else lambda: int(node.get_clock().now().nanoseconds)
    meters: dict[str, _Meter] = {}
    topics = await chosen_topics(session, node, args, "topic_name")
    for topic in topics:
        kind = await wait_for_class(session, node, topic)
        meters[topic] = _Meter(session, now_ns, args.window_size)
        receive = partial(_receive, meters[topic], args.filter_expr)
        node.create_subscription(kind, topic, receive, profile_for_measuring(session, node, args, topic))
        if len(topics) > 1:
            session.print(f"Subscribed to [{topic}]")
    session.spawn(_report(session, args, meters))
    try:
        await session.spin(node)
    except (KeyboardInterrupt, ExternalShutdownException):
        return


def _receive(meter: _Meter, filter_expr: str | None, message: Any) -> None:
    if filter_expr:
        from day6_core.ros.ros2.topic._filter import evaluate

        if not evaluate(filter_expr, message):
            return
    meter.count()


async def _report(session: Session, args: Namespace, meters: dict[str, _Meter]) -> None:
    async for _ in session.every(1.0):
        await session.sleep(0.001)  # messages that arrive at this very moment count too
        rates = {topic: rate for topic, meter in meters.items() if (rate := meter.rate()) is not None}
        if rates:
            clear_above(session, args)
            session.print(_line(*rates.values()) if len(meters) == 1 else _table(rates))


class Rate(NamedTuple):
    """The measurements of one window; periods in seconds."""

    hertz: float
    shortest: float
    longest: float
    deviation: float
    window: int


class _Meter:
    """Measures the periods between messages of one topic; `now_ns` is the clock (nanoseconds)."""

    def __init__(self, session: Session, now_ns: Callable[[], int], window: int) -> None:
        self.session = session
        self.now_ns = now_ns
        self.window = window
        self.first = -1
        self.last = 0
        self.reported = 0
        self.periods: list[int] = []

    def count(self) -> None:
        now = self.now_ns()
        if now == 0:
            if self.periods:
                self.session.print("time has reset, resetting counters")
                self.periods = []
            return
        if self.first < 0 or self.first > now:
            self.first = now
            self.periods = []
        else:
            self.periods.append(now - self.last)
            if len(self.periods) > self.window:
                self.periods.pop(0)
        self.last = now

    def rate(self) -> Rate | None:
        """Return the rate of the window, None if no message has arrived since the last call."""
        if not self.periods or self.last == self.reported:
            return None
        self.reported = self.last
        number = len(self.periods)
        mean = sum(self.periods) / number
        deviation = math.sqrt(sum((period - mean) ** 2 for period in self.periods) / number)
        return Rate(
            1e9 / mean if mean > 0.0 else 0.0,
            min(self.periods) * 1e-9,
            max(self.periods) * 1e-9,
            deviation * 1e-9,
            number,
        )


def _line(rate: Rate) -> str:
    return (
        f"average rate: {rate.hertz:.3f}\n\tmin: {rate.shortest:.3f}s max: {rate.longest:.3f}s "
        f"std dev: {rate.deviation:.5f}s window: {rate.window}"
    )


def _table(rates: dict[str, Rate]) -> str:
    rows = [
        (
            topic,
            f"{rate.hertz:.3f}",
            f"{rate.shortest:.3f}",
            f"{rate.longest:.3f}",
            f"{rate.deviation:.5f}",
            str(rate.window),
        )
        for topic, rate in rates.items()
    ]
    return table(_HEADER, rows)
