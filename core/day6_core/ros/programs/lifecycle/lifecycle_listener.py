"""lifecycle_listener: subscribes to lc_talker's messages and state transitions."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from lifecycle_msgs.msg import TransitionEvent

from day6_core.ros.programs._component import run
from day6_core.ros.programs.demo_messages import String

if TYPE_CHECKING:
    from day6_core.session.session import Session
    from rclpy.node import Node


class LifecycleListener:
    """Subscribes to `lifecycle_chatter` and to the transitions of lc_talker."""

    NAME = "lc_listener"
    OPTIONS: dict[str, Any] = {}

    def __init__(self, node: Node) -> None:
        self._logger = node.get_logger()
        node.create_subscription(String, "lifecycle_chatter", self._hear, 10)
        node.create_subscription(TransitionEvent, "/lc_talker/transition_event", self._notice, 10)

    def _hear(self, message: String) -> None:
        self._logger.info(f"data_callback: {message.data}")

    def _notice(self, event: TransitionEvent) -> None:
        self._logger.info(
            f"notify callback: Transition from state {event.start_state.label} to {event.goal_state.label}"
        )


async def main(session: Session) -> int:
    return await run(session, LifecycleListener)
