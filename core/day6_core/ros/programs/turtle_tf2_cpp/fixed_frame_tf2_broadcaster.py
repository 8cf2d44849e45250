"""fixed_frame_tf2_broadcaster: hangs a carrot two metres beside turtle1."""

from __future__ import annotations

from typing import TYPE_CHECKING

from day6_core.ros.programs._component import spin_cpp
from day6_core.ros.programs.rclcpp import create_node
from day6_core.ros.programs.tf2_ros.broadcasting import TransformBroadcaster
from day6_core.ros.programs.turtle_tf2_py.frames import broadcast_carrot

if TYPE_CHECKING:
    from day6_core.session.session import Session


async def main(session: Session) -> int:
    node = create_node(session, "fixed_frame_tf2_broadcaster")
    broadcast_carrot(node, lambda: (0.0, 2.0, 0.0), TransformBroadcaster)
    return await spin_cpp(session, node)
