"""How programs with a window behave without a screen (`day6-tui exec`, a real process without a terminal).

One rule for all of them. A program that shows a snapshot (rqt_graph, rqt_topic, rqt_bag, rviz2, car_view) prints it once and
ends if something waits for it, that is in the foreground of `exec`; launched, with `&` or without a terminal it keeps running as
a node and logs until it is interrupted. Continuous programs always keep running: rqt_console and rqt_plot print what arrives;
turtlesim, the world, showimage and joint_state_publisher_gui run without their window.
"""

from __future__ import annotations

from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from day6_core.session.session import Session
    from rclpy.node import Node


def stays(session: Session, node: Node) -> bool:
    """Whether the program, which has no screen, keeps running as a node instead of printing once; if so, log that."""
    if session.background:
        say_there_is_none(node)
    return session.background


def say_there_is_none(node: Node) -> None:
    """Log that the program's window is missing."""
    node.get_logger().info("There is no screen for the window: the node runs without it")
