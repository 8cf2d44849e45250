"""Waiting for one message without spinning."""

from __future__ import annotations

import threading
from typing import TYPE_CHECKING, Any

from rclpy.executors import _LONGEST_WAIT_NS
from rclpy.signals import SignalHandlerGuardCondition

if TYPE_CHECKING:
    from rclpy.node import Node
    from rclpy.qos import QoSProfile


def wait_for_message(
    msg_type: type[Any],
    node: Node,
    topic: str,
    *,
    qos_profile: QoSProfile | int = 1,
    time_to_wait: float = -1,
) -> tuple[bool, Any]:
    """Block until the next message of a topic comes, at most `time_to_wait` seconds (negative: for ever).

    Returns (True, message), or (False, None) when time is up or the context was shut down. RuntimeError before init().
    """
    context = node.context
    if context.handle is None:
        raise RuntimeError("Cannot create Waitset without a context.handle")
    arrived = threading.Event()
    subscription = node.create_subscription(msg_type, topic, lambda _: None, qos_profile)
    endpoint = subscription.handle._endpoint
    endpoint.on_ready = lambda _: arrived.set()
    guard = SignalHandlerGuardCondition(context=context)
    stopped = context._watch_end(arrived.set)
    try:
        if not endpoint.queue:
            _wait(arrived, None if time_to_wait < 0 else time_to_wait)
        sample = endpoint.take()
        return (False, None) if sample is None else (True, sample[0])
    finally:
        stopped()
        guard.destroy()
        node.destroy_subscription(subscription)


def _wait(event: threading.Event, seconds: float | None) -> None:
    if _LONGEST_WAIT_NS is None:
        event.wait(seconds)
        return
    # Where an endless wait cannot be interrupted by Ctrl-C it is done in pieces.
    piece = _LONGEST_WAIT_NS / 1e9
    left = float("inf") if seconds is None else seconds
    while left > 0 and not event.wait(min(piece, left)):
        left -= piece
