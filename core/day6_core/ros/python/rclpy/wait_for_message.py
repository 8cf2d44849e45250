"""Waiting for one message without spinning."""

from __future__ import annotations

from typing import TYPE_CHECKING

from rclpy._day6.incidental import also
from rclpy._day6.time_base import AutoResetEvent

if TYPE_CHECKING:
    from rclpy.node import Node
    from rclpy.qos import QoSProfile
    from rclpy.type_support import MsgT

__getattr__ = also(__name__, "Node QoSProfile SignalHandlerGuardCondition timeout_sec_to_nsec")


def wait_for_message(
    msg_type: type[MsgT],
    node: Node,
    topic: str,
    *,
    qos_profile: QoSProfile | int = 1,
    time_to_wait: float = -1,
) -> tuple[bool, MsgT | None]:
    """Block until the next message of a topic comes, at most `time_to_wait` seconds (negative: for ever).

    Returns (True, message), or (False, None) when time is up or the context was shut down.

    Raises:
        RuntimeError: before init().
    """
    context = node.context
    if context.handle is None:
        raise RuntimeError("Cannot create Waitset without a context.handle")
    arrived = AutoResetEvent()
    subscription = node.create_subscription(msg_type, topic, lambda _: None, qos_profile)
    endpoint = subscription.handle._endpoint
    endpoint.on_ready = lambda _: arrived.set()
    stopped = context._watch_end(arrived.set)
    try:
        if not endpoint.queue:
            arrived.wait(None if time_to_wait < 0 else time_to_wait)
        sample = endpoint.take()
        return (False, None) if sample is None else (True, sample[0])
    finally:
        stopped()
        node.destroy_subscription(subscription)
