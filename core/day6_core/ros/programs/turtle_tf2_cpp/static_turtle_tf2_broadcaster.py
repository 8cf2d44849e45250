"""static_turtle_tf2_broadcaster: broadcasts once where a frame is, from its arguments."""

from __future__ import annotations

from typing import TYPE_CHECKING

from day6_core.ros.programs._component import spin_cpp
from day6_core.ros.programs.rclcpp import create_node
from day6_core.ros.programs.tf2_ros.broadcasting import StaticTransformBroadcaster
from day6_core.ros.programs.turtle_tf2_py.frames import broadcast_static, static_words

if TYPE_CHECKING:
    from day6_core.session.session import Session


async def main(session: Session) -> int:
    words = static_words(session, "turtle_tf2_cpp")
    if words is None or words[0] == "world":
        return 1
    node = create_node(session, "static_turtle_tf2_broadcaster")
    broadcast_static(node, words[0], [float(word) for word in words[1:]], StaticTransformBroadcaster)
    return await spin_cpp(session, node)
