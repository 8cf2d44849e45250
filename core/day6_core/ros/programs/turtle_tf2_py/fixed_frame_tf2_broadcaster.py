"""fixed_frame_tf2_broadcaster: hangs a carrot two metres beside turtle1."""

from __future__ import annotations

from typing import TYPE_CHECKING

from day6_core.ros.programs._waiting import spin
from day6_core.ros.programs.turtle_tf2_py.frames import broadcast_carrot

if TYPE_CHECKING:
    from day6_core.session.session import Session


async def main(session: Session) -> int:
    node = session.create_node("fixed_frame_tf2_broadcaster")
    broadcast_carrot(node, lambda: (0.0, 2.0, 0.0))
    return await spin(session, node)
