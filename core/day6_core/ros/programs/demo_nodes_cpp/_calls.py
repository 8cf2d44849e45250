"""Waiting for a service as rclcpp's demos do, and parameter values in rclcpp's words."""

from __future__ import annotations

from collections.abc import Callable
from typing import TYPE_CHECKING, Any

from day6_core.ros.programs._component import ready
from day6_core.ros.programs.rclcpp import STOPPED, log_interrupt

if TYPE_CHECKING:
    from day6_core.session.session import Session
    from rclpy.node import Node


async def wait_for_service(session: Session, node: Node, look: Callable[[], bool]) -> bool:
    """Wait until `look()` is true, saying every second that it is not yet; False when Ctrl-C was pressed."""
    try:
        while not await ready(session, look, 1.0):
            node.get_logger().info("service not available, waiting again...")
    except STOPPED:
        log_interrupt(session)
        node.get_logger().error("Interrupted while waiting for the service. Exiting.")
        return False
    return True


def value_text(kind: int, value: Any) -> str:
    """Return a parameter's value as rclcpp::Parameter::value_to_string does."""
    if isinstance(value, (list, tuple)) or kind >= 5:
        items = [f"0x{ord(item) if isinstance(item, bytes) else item:02x}" for item in value] if kind == 5 else None
        return f"[{', '.join(items if items is not None else [value_text(kind - 5, item) for item in value])}]"
    if isinstance(value, bool):
        return "true" if value else "false"
    return f"{value:f}" if isinstance(value, float) else str(value)
