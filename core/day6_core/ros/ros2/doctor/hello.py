"""`ros2 doctor hello`: sends a hello on a topic and by multicast, and counts the hellos of each other machine."""

from __future__ import annotations

import re
import socket
from argparse import ArgumentParser, ArgumentTypeError, Namespace
from collections import Counter
from collections.abc import Callable
from typing import TYPE_CHECKING, Any

from day6_core.ros.ros2.cli.multicast import GROUP, LARGEST, PORT, member, send
from day6_core.ros.ros2.cli.node import direct_node

if TYPE_CHECKING:
    from day6_core.session.session import Session

SUMMARY = "Check network connectivity between multiple hosts"


def _positive(kind: type[float]) -> Callable[[str], Any]:
    def parse(text: str) -> Any:
        try:
            value = kind(text)
        except ValueError:
            value = kind(-1)
        if value <= 0:
            # The braces are in the real command's text too.
            raise ArgumentTypeError("value must be a positive {type_.__name__}")
        return value

    return parse


def add_arguments(parser: ArgumentParser) -> None:
    parser.add_argument(
        "-t",
        "--topic",
        nargs="?",
        default="/canyouhearme",
        help="Name of ROS topic to publish to (default: '/canyouhearme')",
    )
    for short, long, default, what in (
        ("-ep", "--emit-period", 0.1, "publish/send one message"),
        ("-pp", "--print-period", 1.0, "print summary table"),
    ):
        parser.add_argument(
            short,
            long,
            metavar="N",
            type=_positive(float),
            default=default,
            help=f"Time period to {what} (default: {default}s)",
        )
    parser.add_argument("--ttl", type=_positive(int), help="TTL for multicast send (default: None)")
    parser.add_argument(
        "-1",
        "--once",
        action="store_true",
        help="Publish and multicast send for one emit period then exit; used in test case.",
    )


async def main(session: Session, args: Namespace) -> None:
    from std_msgs.msg import String

    from rclpy.qos import qos_profile_system_default

    host = socket.gethostname()
    name = f"ros2doctor_{re.sub('[^0-9a-zA-Z_]', '_', host)}_{session.pid}_node"
    node = await direct_node(session, None, name)
    counts = getattr(args, "summary_table", None) or SummaryTable()

    def receive(message: Any) -> None:
        sender = _sender(message.data)
        if sender not in ("", host):
            counts.increment_sub(sender)

    publisher = node.create_publisher(String, args.topic, qos_profile_system_default)
    node.create_subscription(String, args.topic, receive, qos_profile_system_default)
    session.executor.add_node(node)
    hello = f"hello, it's me {host}"
    with member(GROUP, PORT) as receiver:
        printed = session.clock.steady_ns()
        try:
            while True:
                now = session.clock.steady_ns()
                if now - printed > args.print_period * 1e9:
                    session.print(*counts.lines(args.topic, args.print_period), sep="\n")
                    counts.reset()
                    printed = now
                publisher.publish(String(data=hello))
                send(hello.encode(), GROUP, PORT, args.ttl)
                counts.increment_pub()
                counts.increment_send()
                await session.sleep(args.emit_period)
                session.spin_some()
                _receive(receiver, host, counts)
                if args.once:
                    session.print(*counts.lines(args.topic, args.print_period), sep="\n")
                    return
        except KeyboardInterrupt:
            return


def _receive(receiver: socket.socket, host: str, counts: SummaryTable) -> None:
    while True:
        try:
            data, _ = receiver.recvfrom(LARGEST)
        except BlockingIOError:
            return
        sender = _sender(data.decode("utf-8", "replace"))
        if sender not in ("", host):
            counts.increment_receive(sender)


def _sender(text: str) -> str:
    words = text.split()
    return words[-1] if words else ""


class SummaryTable:
    """Messages sent and received since the last table."""

    def __init__(self) -> None:
        self.reset()

    def reset(self) -> None:
        """Begin again at nothing."""
        self._pub = 0
        self._send = 0
        self._sub: Counter[str] = Counter()
        self._receive: Counter[str] = Counter()

    def increment_pub(self) -> None:
        """Count a message published."""
        self._pub += 1

    def increment_send(self) -> None:
        """Count a packet sent."""
        self._send += 1

    def increment_sub(self, hostname: str) -> None:
        """Count a message of another machine."""
        self._sub[hostname] += 1

    def increment_receive(self, hostname: str) -> None:
        """Count a packet of another machine."""
        self._receive[hostname] += 1

    def lines(self, topic: str, print_period: float, *, group: str = GROUP, port: int = PORT) -> list[str]:
        """Return the table."""

        def table(counts: Counter[str]) -> list[str]:
            rows = (("Hostname", f"Msg Count /{print_period}s"), *counts.items())
            return [f"{'':<15} {name:<20} {count:<10}" for name, count in rows]

        return [
            "MULTIMACHINE COMMUNICATION SUMMARY",
            f"Topic: {topic}, Published Msg Count: {self._pub}",
            "Subscribed from:",
            *table(self._sub),
            f"Multicast Group/Port: {group}/{port}, Sent Msg Count: {self._send}",
            "Received from:",
            *table(self._receive),
            "-" * 60,
        ]


EXPORTS = {"SummaryTable": SummaryTable}
"""What `ros2doctor.verb.hello` has besides."""
