"""The arguments of talker_qos and listener_qos, and the number of callbacks after which they end."""

from __future__ import annotations

import argparse
from collections.abc import Callable
from typing import TYPE_CHECKING, Any

from rclpy.qos import QoSProfile, QoSReliabilityPolicy, qos_profile_sensor_data
from rclpy.task import Future
from rclpy.utilities import remove_ros_args

if TYPE_CHECKING:
    from day6_core.session.session import Session
    from rclpy.node import Node


def parse(session: Session, number_help: str) -> argparse.Namespace:
    """Parse the program's arguments; raises the parser's end, which `ros2` turns into an exit status."""
    from day6_core.session.argument_parser import SessionParser

    parser = SessionParser(session, prog=session.name)
    parser.add_argument(
        "--reliable", action="store_true", default=False, help="set qos profile to reliable (default: False)"
    )
    parser.add_argument("-n", "--number_of_cycles", type=int, default=20, help=f"{number_help} (default: 20)")
    return parser.parse_args(remove_ros_args(args=session.argv)[1:])


def profile(args: argparse.Namespace) -> QoSProfile:
    """Return reliable with a queue of ten, or the profile of sensor data."""
    if args.reliable:
        return QoSProfile(depth=10, reliability=QoSReliabilityPolicy.RELIABLE)
    return qos_profile_sensor_data


class Turns:
    """Counts callbacks."""

    def __init__(self) -> None:
        self._count = 0
        self._last = -1
        self._over: Future[bool] = Future()

    def each(self, callback: Callable[..., object]) -> Callable[..., None]:
        """Return the callback, counted."""

        def counted(*args: Any) -> None:
            callback(*args)
            self._count += 1
            if self._count == self._last:
                self._over.set_result(True)

        return counted

    async def spin(self, session: Session, node: Node, number: int) -> int:
        """Spin until so many callbacks ran, or Ctrl-C."""
        if number > 0:
            self._last = number
            session.executor.add_node(node)
            try:
                await session.spin_until(self._over)
            except KeyboardInterrupt:
                return 0
        return 0
