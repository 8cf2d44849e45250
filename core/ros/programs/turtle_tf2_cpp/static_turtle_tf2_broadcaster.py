"""static_turtle_tf2_broadcaster: broadcasts once where a frame is, from its arguments."""

from __future__ import annotations

from typing import TYPE_CHECKING

from day6_tui.core.ros.programs._component import spin_cpp
from day6_tui.core.ros.programs._rclcpp import create_node
from day6_tui.core.ros.programs.turtle_tf2_py._frames import broadcast_static
from rclpy.utilities import remove_ros_args

if TYPE_CHECKING:
    from day6_tui.core.session.session import Session


async def main(session: Session) -> int:
    words = remove_ros_args(args=session.argv)[1:]
    seconds, nanoseconds = divmod(session.clock.now_ns(), 1_000_000_000)
    stamp = f"[{seconds}.{nanoseconds:09d}] [logger]"
    if len(words) != 7:
        session.print_error(
            f"[INFO] {stamp}: Invalid number of parameters. Usage: \n"
            "$ ros2 run turtle_tf2_cpp static_turtle_tf2_broadcaster child_frame_name x y z roll pitch yaw"
        )
        return 1
    if words[0] == "world":
        session.print_error(f'[INFO] {stamp}: Your static turtle name cannot be "world"')
        return 1
    node = create_node(session, "static_turtle_tf2_broadcaster")
    broadcast_static(node, words[0], [float(word) for word in words[1:]])
    return await spin_cpp(session, node)
