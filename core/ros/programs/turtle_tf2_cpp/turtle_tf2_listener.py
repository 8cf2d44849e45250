"""turtle_tf2_listener: lets turtle2 follow a frame."""

from __future__ import annotations

from typing import TYPE_CHECKING

from day6_tui.core.ros.programs._component import spin_cpp
from day6_tui.core.ros.programs.rclcpp import create_node
from day6_tui.core.ros.programs.turtle_tf2_py.frames import Follower

if TYPE_CHECKING:
    from day6_tui.core.session.session import Session


async def main(session: Session) -> int:
    node = create_node(session, "turtle_tf2_frame_listener")
    follower = Follower(node)
    session.defer(lambda: follower)  # keeps its listener
    return await spin_cpp(session, node)
