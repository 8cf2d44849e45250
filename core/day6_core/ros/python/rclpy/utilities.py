"""The default context, and functions that need no node."""

from __future__ import annotations

import os
import sys
import threading
from collections.abc import Sequence

from rclpy._day6.incidental import also
from rclpy.constants import S_TO_NS
from rclpy.context import Context

__getattr__ = also(__name__)

g_default_context: Context | None = None
g_context_lock = threading.RLock()

RMW_IMPLEMENTATION = "rmw_fastrtps_cpp"
"""The default of real ROS 2, whose behaviour and texts this rclpy has (the link speaks rmw_zenoh)."""


def get_default_context(*, shutting_down: bool = False) -> Context:
    """Return the context used by default; with `shutting_down` the next call makes a new one."""
    global g_default_context
    context = g_default_context
    if context is not None and not shutting_down:
        return context
    with g_context_lock:
        context = g_default_context
        if context is None:
            context = g_default_context = Context()
        if shutting_down:
            g_default_context = None
        return context


def remove_ros_args(args: Sequence[str] | None = None) -> list[str]:
    """Return command line arguments (by default `sys.argv`) without those for ROS."""
    from rclpy._day6.arguments import remove_ros_arguments

    return remove_ros_arguments(sys.argv if args is None else args)


def ok(*, context: Context | None = None) -> bool:
    """Return whether a context (by default the default one) is initialised and not shut down."""
    return (get_default_context() if context is None else context).ok()


def shutdown(*, context: Context | None = None) -> None:
    """Shut a context down.

    Raises:
        RuntimeError: if it was never initialised.
    """
    if context is None:
        context = get_default_context(shutting_down=True)
    context.shutdown()


def try_shutdown(*, context: Context | None = None) -> None:
    """Shut a context down unless it already was."""
    global g_default_context
    if context is not None:
        context.try_shutdown()
        return
    with g_context_lock:
        default = get_default_context()
        default.try_shutdown()
        if not default.ok():
            g_default_context = None


def get_rmw_implementation_identifier() -> str:
    """Return the name of the middleware."""
    return os.environ.get("RMW_IMPLEMENTATION") or RMW_IMPLEMENTATION


def get_available_rmw_implementations() -> set[str]:
    """Return the names of all middlewares that can be used; RMW_IMPLEMENTATIONS limits them (RuntimeError if unknown)."""
    available = {RMW_IMPLEMENTATION}
    wanted = os.environ.get("RMW_IMPLEMENTATIONS")
    if not wanted:
        return available
    names = set(wanted.split(os.pathsep))
    missing = names - available
    if missing:
        raise RuntimeError(
            f"The RMW implementations {missing} specified in 'RMW_IMPLEMENTATIONS' are not available "
            f"({', '.join(sorted(available))})"
        )
    return available & names


def timeout_sec_to_nsec(timeout_sec: float | None) -> int:
    """Return a timeout in nanoseconds; -1 (for ever) for None and negative ones."""
    return -1 if timeout_sec is None or timeout_sec < 0 else int(float(timeout_sec) * S_TO_NS)
