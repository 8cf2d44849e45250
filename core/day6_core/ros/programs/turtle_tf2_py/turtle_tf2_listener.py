"""turtle_tf2_listener: lets turtle2 follow a frame."""

from __future__ import annotations

from typing import TYPE_CHECKING

from day6_core.ros.programs._waiting import spin
from day6_core.ros.programs.turtle_tf2_py.frames import Follower

if TYPE_CHECKING:
    from day6_core.session.session import Session


async def main(session: Session) -> int:
    node = session.create_node("turtle_tf2_frame_listener")
    follower = Follower(node)
    session.defer(lambda: follower)  # keeps its listener
    return await spin(session, node)
