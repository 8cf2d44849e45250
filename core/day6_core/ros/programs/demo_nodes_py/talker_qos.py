"""talker_qos: a talker that is best effort, or with --reliable reliable; ends after --number_of_cycles callbacks."""

from __future__ import annotations

from typing import TYPE_CHECKING

from day6_core.ros.programs.demo_messages import String
from day6_core.ros.programs.demo_nodes_py._qos import Turns, parse, profile

if TYPE_CHECKING:
    from day6_core.session.session import Session


async def main(session: Session) -> int:
    args = parse(session, "number of sending attempts")
    turns = Turns()
    node = session.create_node("talker_qos")
    node.get_logger().info("Reliable talker" if args.reliable else "Best effort talker")
    publisher = node.create_publisher(String, "chatter", profile(args))
    count = 0

    def publish() -> None:
        nonlocal count
        message = String(data=f"Hello World: {count}")
        count += 1
        node.get_logger().info(f'Publishing: "{message.data}"')
        publisher.publish(message)

    node.create_timer(1.0, turns.each(publish))
    return await turns.spin(session, node, args.number_of_cycles)
