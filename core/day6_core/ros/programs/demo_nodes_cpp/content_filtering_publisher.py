"""content_filtering_publisher: temperatures from -100 to 150 in steps of ten."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from day6_core.ros.programs._component import run
from day6_core.ros.programs.demo_messages import Float32
from rclpy.qos import QoSProfile

COLDEST, HOTTEST, STEP = -100.0, 150.0, 10.0

if TYPE_CHECKING:
    from day6_core.session.session import Session
    from rclpy.node import Node


class ContentFilteringPublisher:
    """Parameter `publish_ms`: milliseconds between two."""

    NAME = "content_filtering_publisher"
    OPTIONS: dict[str, Any] = {}

    def __init__(self, node: Node) -> None:
        self._logger = node.get_logger()
        self._publisher = node.create_publisher(Float32, "temperature", QoSProfile(depth=7))
        self._temperature = COLDEST
        period = node.declare_parameter("publish_ms", 1000).value
        node.create_timer(period / 1000, self._publish)

    def _publish(self) -> None:
        message = Float32(data=self._temperature)
        self._temperature += STEP
        if self._temperature > HOTTEST:
            self._temperature = COLDEST
        self._logger.info(f"Publishing: '{message.data:f}'")
        self._publisher.publish(message)


async def main(session: Session) -> int:
    return await run(session, ContentFilteringPublisher)
