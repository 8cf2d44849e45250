"""listener_qos: a listener that is best effort, or with --reliable reliable; ends after --number_of_cycles callbacks."""

from __future__ import annotations

from typing import TYPE_CHECKING

from day6_core.ros.programs.demo_messages import String
from day6_core.ros.programs.demo_nodes_py._qos import Turns, parse, profile

if TYPE_CHECKING:
    from day6_core.session.session import Session


async def main(session: Session) -> int:
    args = parse(session, "max number of spin_once iterations")
    turns = Turns()
    node = session.create_node("listener_qos")
    node.get_logger().info("Reliable listener" if args.reliable else "Best effort listener")
    hear = turns.each(lambda message: node.get_logger().info(f"I heard: [{message.data}]"))
    node.create_subscription(String, "chatter", hear, profile(args))
    return await turns.spin(session, node, args.number_of_cycles)
