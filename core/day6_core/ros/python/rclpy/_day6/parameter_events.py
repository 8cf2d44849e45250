"""The topic /parameter_events, on which every node publishes the changes of its parameters."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from rclpy._day6.endpoint_handles import PublisherHandle
from rclpy._day6.own_services import HASHES, PARAMETER_EVENT, copy_any
from rclpy.publisher import Publisher

if TYPE_CHECKING:
    from rcl_interfaces.msg import ParameterEvent

    from rclpy._day6.handles import NodeHandle
    from rclpy.callback_groups import CallbackGroup
    from rclpy.clock import Clock
    from rclpy.parameter import Parameter
    from rclpy.qos import QoSProfile

_TOPIC = "/parameter_events"


class ParameterEvents:
    """Publishes the changes of a node's parameters: the listener of the node's `ParameterStore`."""

    def __init__(self, publisher: Publisher[ParameterEvent] | None, node: NodeHandle, clock: Clock) -> None:
        self.publisher = publisher
        self._node = node
        self._clock = clock

    def require(self) -> None:
        """Raise InvalidHandle for a destroyed node."""
        self._node.check()

    def has_subscribers(self) -> bool:
        """Return whether there are subscriptions; raises RCLError if the context was shut down."""
        return self.publisher is not None and self.publisher._has_subscribers()

    def changed(self, new: list[Parameter[Any]], changed: list[Parameter[Any]], deleted: list[Parameter[Any]]) -> None:
        """Publish parameters that were set together as one event."""
        from rcl_interfaces.msg import ParameterEvent

        if self.publisher is not None:
            self.publisher.publish(
                ParameterEvent(
                    stamp=self._clock.now().to_msg(),
                    node=self._node.get_fully_qualified_name(),
                    new_parameters=[parameter.to_parameter_msg() for parameter in new],
                    changed_parameters=[parameter.to_parameter_msg() for parameter in changed],
                    deleted_parameters=[parameter.to_parameter_msg() for parameter in deleted],
                )
            )


def parameter_event_publisher(node: NodeHandle, group: CallbackGroup, qos: QoSProfile) -> Publisher[ParameterEvent]:
    """Return the publisher of a node's parameter events; its message class is made only when an event is published."""
    topic = node.resolve(_TOPIC, is_service=False)
    node.claim_topic(topic, PARAMETER_EVENT, "publisher", "")
    endpoint = node.node.create_publisher(
        topic, PARAMETER_EVENT, HASHES[PARAMETER_EVENT], qos.get_c_qos_profile(), copy_any
    )
    handle = PublisherHandle._of(node, endpoint, is_topic=True)
    publisher: Publisher[Any] = Publisher(handle, object, _TOPIC, qos, None, group)
    return publisher
