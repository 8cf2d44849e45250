"""turtle_tf2_broadcaster: broadcasts where a turtle is."""

from __future__ import annotations

from typing import TYPE_CHECKING

from day6_core.ros.programs._waiting import spin
from day6_core.ros.programs.turtle_tf2_py.frames import broadcast_turtle

if TYPE_CHECKING:
    from day6_core.session.session import Session


async def main(session: Session) -> int:
    node = session.create_node("turtle_tf2_frame_publisher")
    broadcast_turtle(node)
    return await spin(session, node)
