"""content_filtering_subscriber: subscribes only to temperatures that are an emergency."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from day6_core.ros.programs._component import run
from day6_core.ros.programs.demo_messages import Float32
from rclpy.subscription_content_filter_options import ContentFilterOptions

LOW, HIGH = -30.0, 100.0

if TYPE_CHECKING:
    from day6_core.session.session import Session
    from rclpy.node import Node


class ContentFilteringSubscriber:
    """Subscribes to `temperature` with a content filter, where there are any."""

    NAME = "content_filtering_subscriber"
    OPTIONS: dict[str, Any] = {}

    def __init__(self, node: Node) -> None:
        self._logger = node.get_logger()
        options = ContentFilterOptions(
            filter_expression="data < %0 OR data > %1", expression_parameters=[f"{LOW:f}", f"{HIGH:f}"]
        )
        subscription = node.create_subscription(
            Float32, "temperature", self._measure, 10, content_filter_options=options
        )
        if subscription.is_cft_enabled:
            self._logger.info(
                f'subscribed to topic "{subscription.topic_name}" with content filter options '
                f'"{options.filter_expression}, {{{", ".join(options.expression_parameters)}}}"'
            )
        else:
            self._logger.warning("Content filter is not enabled since it's not supported")

    def _measure(self, message: Float32) -> None:
        kind = "a temperature" if LOW <= message.data <= HIGH else "an emergency temperature"
        self._logger.info(f"I receive {kind} data: [{message.data:f}]")


async def main(session: Session) -> int:
    return await run(session, ContentFilteringSubscriber)
