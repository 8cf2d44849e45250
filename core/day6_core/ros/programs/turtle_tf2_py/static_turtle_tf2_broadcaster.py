"""static_turtle_tf2_broadcaster: broadcasts once where a frame is, from its arguments."""

from __future__ import annotations

from typing import TYPE_CHECKING

from day6_core.ros.programs._waiting import spin
from day6_core.ros.programs.turtle_tf2_py.frames import broadcast_static, static_words

if TYPE_CHECKING:
    from day6_core.session.session import Session


async def main(session: Session) -> int:
    words = static_words(session, "turtle_tf2_py")
    if words is None:
        return 1
    if words[0] == "world":
        return 2
    node = session.create_node("static_turtle_tf2_broadcaster")
    broadcast_static(node, words[0], [float(word) for word in words[1:]])
    return await spin(session, node)
