"""turtle_tf2_listener: lets turtle2 follow a frame."""

from __future__ import annotations

from typing import TYPE_CHECKING

from day6_core.ros.programs._component import spin_cpp
from day6_core.ros.programs.rclcpp import create_node
from day6_core.ros.programs.tf2_ros.listening import listen
from day6_core.ros.programs.turtle_tf2_py.frames import Follower

if TYPE_CHECKING:
    from day6_core.session.session import Session
    from rclpy.node import Node


async def main(session: Session) -> int:
    node = create_node(session, "turtle_tf2_frame_listener")
    listeners: list[Node] = []
    follower = Follower(node, lambda buffer, _: listeners.append(listen(session, buffer)))
    session.defer(lambda: follower)  # its timer does not keep it
    return await spin_cpp(session, node, *listeners)
