"""dynamic_frame_tf2_broadcaster: lets a carrot swing around turtle1."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING

from day6_core.ros.programs._component import spin_cpp
from day6_core.ros.programs.rclcpp import create_node
from day6_core.ros.programs.tf2_ros.broadcasting import TransformBroadcaster
from day6_core.ros.programs.turtle_tf2_py.frames import broadcast_carrot
from day6_core.session.clock import NANOSECONDS

if TYPE_CHECKING:
    from day6_core.session.session import Session


async def main(session: Session) -> int:
    node = create_node(session, "dynamic_frame_tf2_broadcaster")

    def place() -> tuple[float, float, float]:
        # Whole seconds only, as in the original: the carrot jumps from one side to the other.
        angle = math.pi * (session.timer_ns(node) // NANOSECONDS)
        return 10 * math.sin(angle), 10 * math.cos(angle), 0.0

    broadcast_carrot(node, place, TransformBroadcaster)
    return await spin_cpp(session, node)
