"""server: computes Fibonacci numbers, every goal at once."""

from __future__ import annotations

from typing import TYPE_CHECKING

from day6_core.ros.programs._waiting import spin
from day6_core.ros.programs.examples_rclpy_minimal_action_server._servers import PlainServer

if TYPE_CHECKING:
    from day6_core.session.session import Session


async def main(session: Session) -> int:
    node = session.create_node("minimal_action_server")
    PlainServer(node)
    return await spin(session, node)
