"""server_queue_goals: computes Fibonacci numbers, one goal after the other."""

from __future__ import annotations

from typing import TYPE_CHECKING

from day6_core.ros.programs._waiting import spin
from day6_core.ros.programs.examples_rclpy_minimal_action_server._servers import QueueingServer

if TYPE_CHECKING:
    from day6_core.session.session import Session


async def main(session: Session) -> int:
    node = session.create_node("minimal_action_server")
    QueueingServer(node)
    return await spin(session, node)
