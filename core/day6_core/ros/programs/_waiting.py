"""Shared by programs written like rclpy's demos: spin until Ctrl-C, wait for a service, pause in a callback."""

from __future__ import annotations

from collections.abc import Callable
from typing import TYPE_CHECKING, Any

from day6_core.session.session import STOPPED
from rclpy.task import Future

if TYPE_CHECKING:
    from day6_core.session.session import Session
    from rclpy.node import Node

POLL_SECONDS = 0.02


async def spin(session: Session, *nodes: Node) -> int:
    """Spin until SIGINT, SIGTERM or shutdown, which is a node's normal end: status 0."""
    try:
        await session.spin(*nodes)
    except STOPPED:
        return 0
    return 0


async def wait_until(
    session: Session, look: Callable[[], bool], complain: Callable[[], object], seconds: float = 1.0
) -> None:
    """Wait until `look()` is true; call `complain()` at every interval while it is not."""
    deadline = session.clock.steady_ns() + int(seconds * 1e9)
    while not look():
        if session.clock.steady_ns() >= deadline:
            complain()
            deadline += int(seconds * 1e9)
        await session.sleep(POLL_SECONDS)


async def pause(node: Node, seconds: float) -> None:
    """Wait inside a node's callback; where a real demo's sleep blocks its executor, other programs go on here."""
    over: Future[bool] = Future()

    def ring() -> None:
        node.destroy_timer(timer)
        over.set_result(True)

    timer: Any = node.create_timer(seconds, ring)
    await over
