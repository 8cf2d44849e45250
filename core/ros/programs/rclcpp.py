"""The visible differences between a C++ node and a Python one.

turtlesim is written in C++. `ros2 node info` and Ctrl-C show that, so its copy here behaves accordingly.
"""

from __future__ import annotations

from typing import TYPE_CHECKING, Any, NoReturn

from rcl_interfaces.msg import ParameterEvent

from day6_tui.core.session.session import KilledBySignal
from rclpy.qos import QoSProfile, qos_profile_parameter_events

if TYPE_CHECKING:
    from day6_tui.core.session.session import Session
    from rclpy.node import Node

TOPIC_QOS = QoSProfile(depth=7)
"""Of every topic of turtlesim and its tutorials: keep last 7, reliable, volatile (turtlesim/qos.hpp)."""


SIGABRT = 6


def create_node(session: Session, name: str, **keywords: Any) -> Node:
    """Return a node of this program with the subscription that every rclcpp node's clock has on /parameter_events."""
    node = session.create_node(name, **keywords)
    node.create_subscription(ParameterEvent, "/parameter_events", _ignore, qos_profile_parameter_events)
    return node


def log_interrupt(session: Session) -> None:
    """Print what rclcpp's signal handler logs at Ctrl-C; that logger belongs to no node, so nothing goes to /rosout."""
    seconds, nanoseconds = divmod(session.clock.now_ns(), 1_000_000_000)
    session.print_error(f"[INFO] [{seconds}.{nanoseconds:09d}] [rclcpp]: signal_handler(SIGINT/SIGTERM)")


def abort(session: Session, kind: str, what: str) -> NoReturn:
    """End the program as an uncaught C++ exception of class `kind` does: its text, then SIGABRT (raises KilledBySignal)."""
    session.print_error(f"terminate called after throwing an instance of '{kind}'")
    session.print_error(f"  what():  {what}")
    raise KilledBySignal(SIGABRT)


def _ignore(_: object) -> None:
    """rclcpp looks for `use_sim_time` in these events; here the node's own parameter callback sees to that."""
