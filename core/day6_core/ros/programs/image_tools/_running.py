"""How both programs of image_tools run: usage, a node, and the component on it."""

from __future__ import annotations

from collections.abc import Callable
from typing import TYPE_CHECKING

from day6_core.ros.programs.image_tools.shown_image import ImageWindow
from day6_core.ros.programs.rclcpp import STOPPED, CppException, create_node, log_interrupt

if TYPE_CHECKING:
    from day6_core.session.session import Session
    from rclpy.node import Node


async def run(session: Session, usage: str, name: str, component_of: Callable[[Node, ImageWindow], object]) -> int:
    """Print `usage` if it is asked for; else run the component until interrupted. Raises CppException for a bad parameter."""
    if {"-h", "--help"} & set(session.argv[1:]):
        session.print(usage)
        return 0
    node, window = create_node(session, name), ImageWindow(session)
    try:
        component = component_of(node, window)
    except RuntimeError as error:
        raise CppException(str(error)) from None
    try:
        await session.spin(node)
    except STOPPED:
        if not window.closed:
            log_interrupt(session)
    del component  # it lives as long as its node spins
    return 0
