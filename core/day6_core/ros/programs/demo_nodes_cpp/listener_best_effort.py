"""listener_best_effort: a listener that may miss messages, with best-effort reliability."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from day6_core.ros.programs._component import run
from day6_core.ros.programs.demo_messages import String
from rclpy.qos import qos_profile_sensor_data

if TYPE_CHECKING:
    from day6_core.session.session import Session
    from rclpy.node import Node


class ListenerBestEffort:
    """Subscribes to `chatter` with the QoS of sensor data."""

    NAME = "listener"
    OPTIONS: dict[str, Any] = {}

    def __init__(self, node: Node) -> None:
        self._logger = node.get_logger()
        node.create_subscription(String, "chatter", self._hear, qos_profile_sensor_data)

    def _hear(self, message: String) -> None:
        self._logger.info(f"I heard: [{message.data}]")


async def main(session: Session) -> int:
    return await run(session, ListenerBestEffort)
