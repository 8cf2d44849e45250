"""reuse_timer: every third time a timer resets another one, which fires once."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from day6_core.ros.programs._component import run

if TYPE_CHECKING:
    from day6_core.session.session import Session
    from rclpy.node import Node


class ReuseTimerNode:
    """Two seconds, and one second after."""

    NAME = "reuse_timer"
    OPTIONS: dict[str, Any] = {}

    def __init__(self, node: Node) -> None:
        self._info = node.get_logger().info
        self._count = 0
        self._one_off = node.create_timer(1.0, self._ring_once, autostart=False)
        node.create_timer(2.0, self._ring)

    def _ring(self) -> None:
        self._info("in periodic_timer callback")
        if self._count % 3 == 0:
            self._info("  resetting one off timer")
            self._one_off.reset()
        else:
            self._info("  not resetting one off timer")
        self._count += 1

    def _ring_once(self) -> None:
        self._info("in one_off_timer callback")
        self._one_off.cancel()


async def main(session: Session) -> int:
    return await run(session, ReuseTimerNode)
