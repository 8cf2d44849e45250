"""What programs with a window do where there is no screen (`day6-tui exec`, a real process without a terminal).

One rule for all of them. What has a picture of a moment (rqt_graph, rqt_topic, rviz2, car_view) prints it once and ends when
somebody waits for its answer, that is in the foreground of `exec`; launched, with `&` or without a terminal it stays and logs as
a node until it is interrupted. What goes on anyway does the same everywhere: rqt_console and rqt_plot print what comes,
turtlesim, the world and joint_state_publisher_gui run without their window.
"""

from __future__ import annotations

from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from day6_tui.core.session.session import Session
    from rclpy.node import Node


def stays(session: Session, node: Node) -> bool:
    """Whether the program, which has no screen, goes on as a node instead of printing once; then this is logged."""
    if session.background:
        node.get_logger().info("There is no screen for the window: the node runs without it")
    return session.background
